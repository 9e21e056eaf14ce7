namespace NeuronMocap;

/// <summary>What a reader's connection is doing.</summary>
public enum ConnectionState
{
    /// <summary>Made, not started.</summary>
    Created,

    /// <summary>Resolving the name, connecting, or binding the UDP port.</summary>
    Connecting,

    /// <summary>The connection stands or the UDP port is bound; no frame has arrived yet.</summary>
    Connected,

    /// <summary>Frames arrive.</summary>
    Receiving,

    /// <summary>The connection stands, but no frame has arrived for the time of the silence option; the reason says what did.</summary>
    Silent,

    /// <summary>The connection failed or ended; another attempt follows.</summary>
    Waiting,

    /// <summary>Ended for good: by the caller, or because reconnecting is off.</summary>
    Stopped,
}
