namespace NeuronMocap.Commands;

/// <summary>A command was not answered, or not with something that can be its answer. The client can be used again.</summary>
public sealed class NeuronCommandException : NeuronException
{
    /// <summary>Makes an exception without a reason.</summary>
    public NeuronCommandException()
    {
    }

    /// <summary>Makes an exception without a reason.</summary>
    /// <param name="message">What happened and which setting to look at.</param>
    public NeuronCommandException(string message)
        : base(message)
    {
    }

    /// <summary>Makes an exception that another one caused.</summary>
    /// <param name="message">What happened and which setting to look at.</param>
    /// <param name="innerException">The cause.</param>
    public NeuronCommandException(string message, Exception innerException)
        : base(message, innerException)
    {
    }

    /// <summary>Makes an exception.</summary>
    /// <param name="reason">Why there is no answer.</param>
    /// <param name="message">What happened and which setting to look at.</param>
    /// <param name="innerException">The cause, where there is one.</param>
    public NeuronCommandException(CommandFailure reason, string message, Exception? innerException = null)
        : base(message, innerException!) => Reason = reason;

    /// <summary>Why there is no answer.</summary>
    public CommandFailure Reason { get; }

    // The server did answer, though not what was asked for.
    internal bool IsAnswer => Reason is CommandFailure.Rejected or CommandFailure.InvalidReply;
}
