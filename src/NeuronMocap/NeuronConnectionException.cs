namespace NeuronMocap;

/// <summary>A reader has no connection: it could not connect in the given time, or the connection failed and reconnecting is off.</summary>
public sealed class NeuronConnectionException : NeuronException
{
    /// <summary>Creates an exception without a reason.</summary>
    public NeuronConnectionException()
    {
    }

    /// <summary>Creates an exception without a reason.</summary>
    /// <param name="message">What happened and which setting to look at.</param>
    public NeuronConnectionException(string message)
        : base(message)
    {
    }

    /// <summary>Creates an exception that wraps its cause.</summary>
    /// <param name="message">What happened and which setting to look at.</param>
    /// <param name="innerException">The cause.</param>
    public NeuronConnectionException(string message, Exception innerException)
        : base(message, innerException)
    {
    }

    /// <summary>Creates an exception.</summary>
    /// <param name="reason">Why there is no connection.</param>
    /// <param name="message">What happened and which setting to look at.</param>
    public NeuronConnectionException(ConnectionReason reason, string message)
        : base(message) => Reason = reason;

    internal NeuronConnectionException(ConnectionReason reason, string message, ConnectionStatus lastStatus)
        : this(reason, message) => LastStatus = lastStatus;

    /// <summary>The last status before a wait timed out, which says how the last attempt ended; null in all other cases.</summary>
    public ConnectionStatus? LastStatus { get; }

    /// <summary>Why there is no connection.</summary>
    public ConnectionReason Reason { get; }
}
