namespace NeuronMocap;

/// <summary>On which thread a reader receives, and so runs the handlers of its frames.</summary>
public enum ReceiveThread
{
    /// <summary>
    /// Over TCP a thread of its own for each of the first 16 connections of the process, the pool's threads for more; over UDP the pool's threads. Unity and
    /// other programs on .NET Standard 2.1 have a thread for every TCP connection.
    /// </summary>
    Auto,

    /// <summary>
    /// A thread of its own, however many there are: the least delay, and it needs no thread of the pool. On .NET Standard 2.1 there is no such way for
    /// UDP, which then uses the pool's threads.
    /// </summary>
    Dedicated,

    /// <summary>
    /// The threads of the pool, one at a time: no thread and no buffer while nothing arrives. Frames wait where the program blocks the pool.
    /// On .NET Standard 2.1 there is no such way for TCP, and the connection has a thread of its own.
    /// </summary>
    Pool,
}
