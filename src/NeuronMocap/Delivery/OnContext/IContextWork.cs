namespace NeuronMocap.Delivery;

// What a ContextRunner runs.
internal interface IContextWork
{
    // On the context, one call at a time. Returns when nothing is due, or after the limit. Exceptions belong to the application.
    void Work(long limit);

    // Returns false if there is nothing to do. due: the time before which nothing will be; 0 for now. One call at a time.
    bool TryGetDue(out long due);

    // The context is gone. Any thread.
    void OnLost(FrameDeliveryEnd end);
}
