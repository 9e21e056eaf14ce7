namespace NeuronMocap.Commands;

/// <summary>A command was not answered, or the answer is not valid. The client stays usable.</summary>
public sealed class NeuronCommandException : NeuronException
{
    /// <summary>Creates an exception without a reason.</summary>
    public NeuronCommandException()
    {
    }

    /// <summary>Creates an exception without a reason.</summary>
    /// <param name="message">What happened and which setting to look at.</param>
    public NeuronCommandException(string message)
        : base(message)
    {
    }

    /// <summary>Creates an exception that wraps its cause.</summary>
    /// <param name="message">What happened and which setting to look at.</param>
    /// <param name="innerException">The cause.</param>
    public NeuronCommandException(string message, Exception innerException)
        : base(message, innerException)
    {
    }

    /// <summary>Creates an exception.</summary>
    /// <param name="reason">Why there is no answer.</param>
    /// <param name="message">What happened and which setting to look at.</param>
    /// <param name="innerException">The cause; may be null.</param>
    public NeuronCommandException(CommandFailure reason, string message, Exception? innerException = null)
        : base(message, innerException!) => Reason = reason;

    /// <summary>Why there is no answer.</summary>
    public CommandFailure Reason { get; }

    // The server did answer, but without the requested value.
    internal bool IsAnswer => Reason is CommandFailure.Rejected or CommandFailure.InvalidReply;
}
