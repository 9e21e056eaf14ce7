namespace NeuronMocap;

/// <summary>The state of a reader's connection.</summary>
public enum ConnectionState
{
    /// <summary>The reader is not started yet.</summary>
    Created,

    /// <summary>The reader resolves the name, connects, or binds the UDP port.</summary>
    Connecting,

    /// <summary>The connection is established or the UDP port is bound; no frame has arrived yet.</summary>
    Connected,

    /// <summary>Frames arrive.</summary>
    Receiving,

    /// <summary>The connection is established, but no frame has arrived for the silence timeout; the reason says what did arrive.</summary>
    Silent,

    /// <summary>The connection failed or ended; another attempt follows.</summary>
    Waiting,

    /// <summary>The reader has ended for good: the caller stopped it, or reconnecting is off.</summary>
    Stopped,
}
