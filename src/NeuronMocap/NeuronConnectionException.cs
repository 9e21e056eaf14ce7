namespace NeuronMocap;

/// <summary>A reader could not connect, or lost its connection, and does not try again; or it had no connection in the time that was given to it.</summary>
public sealed class NeuronConnectionException : NeuronException
{
    /// <summary>Makes an exception without a reason.</summary>
    public NeuronConnectionException()
    {
    }

    /// <summary>Makes an exception without a reason.</summary>
    /// <param name="message">What happened and which setting to look at.</param>
    public NeuronConnectionException(string message)
        : base(message)
    {
    }

    /// <summary>Makes an exception that another one caused.</summary>
    /// <param name="message">What happened and which setting to look at.</param>
    /// <param name="innerException">The cause.</param>
    public NeuronConnectionException(string message, Exception innerException)
        : base(message, innerException)
    {
    }

    /// <summary>Makes an exception.</summary>
    /// <param name="reason">Why there is no connection.</param>
    /// <param name="message">What happened and which setting to look at.</param>
    public NeuronConnectionException(ConnectionReason reason, string message)
        : base(message) => Reason = reason;

    internal NeuronConnectionException(ConnectionReason reason, string message, ConnectionStatus lastStatus)
        : this(reason, message) => LastStatus = lastStatus;

    /// <summary>The status that tells how the last attempt ended, where a time to wait ran out; else null.</summary>
    public ConnectionStatus? LastStatus { get; }

    /// <summary>Why there is no connection.</summary>
    public ConnectionReason Reason { get; }
}
