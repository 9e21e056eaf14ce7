namespace NeuronMocap;

/// <summary>Base class of the exceptions for causes outside the program: the network, a server, a file.</summary>
public class NeuronException : Exception
{
    /// <summary>Creates an exception without a message.</summary>
    public NeuronException()
    {
    }

    /// <summary>Creates an exception.</summary>
    /// <param name="message">What happened and what to do about it.</param>
    public NeuronException(string message)
        : base(message)
    {
    }

    /// <summary>Creates an exception that wraps its cause.</summary>
    /// <param name="message">What happened and what to do about it.</param>
    /// <param name="innerException">The cause.</param>
    public NeuronException(string message, Exception innerException)
        : base(message, innerException)
    {
    }
}
