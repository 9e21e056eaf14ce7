namespace NeuronMocap;

/// <summary>The kind of thread on which a reader receives and runs the handlers of frames.</summary>
public enum ReceiveThread
{
    /// <summary>
    /// Each of the first 16 TCP connections and UDP ports of the process has its own thread, and further ones use pool threads. A
    /// <see cref="ByteSource"/> uses pool threads, because some streams have no blocking reads. A broadcaster of this process gives each reader its own
    /// thread. On .NET Standard, for example in Unity, every TCP connection and every stream has its own thread, and UDP uses pool threads.
    /// </summary>
    Auto,

    /// <summary>
    /// Each connection has its own thread, regardless of their number. This has the shortest delay and needs no pool thread. A stream is then read with
    /// blocking calls. A <c>PipeReader</c> always uses pool threads. On .NET Standard this is not available for UDP, which then uses pool threads.
    /// </summary>
    Dedicated,

    /// <summary>
    /// Connections use pool threads, one at a time. They need no thread and no buffer while nothing arrives. If the program blocks the pool, frames wait.
    /// A stream that is neither a socket nor a pipe of the system keeps a buffer. On .NET Standard this is not available for TCP and streams, nor anywhere
    /// for a broadcaster of this process. These have their own threads.
    /// </summary>
    Pool,
}
