namespace NeuronMocap;

/// <summary>The kind of thread on which a reader receives and runs the handlers of frames.</summary>
public enum ReceiveThread
{
    /// <summary>
    /// Over TCP, each of the first 16 connections of the process has its own thread, and further connections use pool threads. UDP uses pool threads.
    /// On .NET Standard 2.1, for example in Unity, every TCP connection has its own thread.
    /// </summary>
    Auto,

    /// <summary>
    /// Each connection has its own thread, regardless of their number. This has the shortest delay and needs no pool thread. On .NET Standard 2.1 this is
    /// not available for UDP, which then uses pool threads.
    /// </summary>
    Dedicated,

    /// <summary>
    /// Connections use pool threads, one at a time. They need no thread and no buffer while nothing arrives. If the program blocks the pool, frames wait.
    /// On .NET Standard 2.1 this is not available for TCP, and the connection has its own thread.
    /// </summary>
    Pool,
}
