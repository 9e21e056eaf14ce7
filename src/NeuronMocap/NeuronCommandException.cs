using NeuronMocap.Commands;

namespace NeuronMocap;

/// <summary>A command to the server got no right answer.</summary>
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
    /// <param name="failure">What went wrong.</param>
    /// <param name="message">What happened and which setting to look at.</param>
    public NeuronCommandException(CommandFailure failure, string message)
        : base(message) => Failure = failure;

    /// <summary>What went wrong.</summary>
    public CommandFailure Failure { get; }
}
