namespace NeuronMocap.Recording;

/// <summary>A file is no recording, or its head is damaged, or a newer version of the format.</summary>
public sealed class RecordingFormatException : NeuronException
{
    /// <summary>Makes an exception without a message.</summary>
    public RecordingFormatException()
    {
    }

    /// <summary>Makes an exception.</summary>
    /// <param name="message">What is wrong.</param>
    public RecordingFormatException(string message)
        : base(message)
    {
    }

    /// <summary>Makes an exception that another one caused.</summary>
    /// <param name="message">What is wrong.</param>
    /// <param name="innerException">The cause.</param>
    public RecordingFormatException(string message, Exception innerException)
        : base(message, innerException)
    {
    }
}
