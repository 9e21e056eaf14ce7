namespace NeuronMocap.Delivery;

// Remembers which thread runs code of the application on the path of a packet. That code can stop the reader, which then must not wait for this thread.
// Set only around such code: the number of a thread costs a tenth of the time of the whole path. Between the two calls, nothing throws, and no other pair begins.
internal sealed class HandlerThread
{
    // The number of the thread, or 0. Other threads may see an old value.
    public int Number { get; private set; }

    public void Enter() => Number = Environment.CurrentManagedThreadId;

    public void Leave() => Number = 0;
}
