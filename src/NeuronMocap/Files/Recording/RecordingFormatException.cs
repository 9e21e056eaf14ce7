namespace NeuronMocap.Recording;

/// <summary>The exception that is thrown when a file is not a recording, has a damaged header, or has a newer version of the format.</summary>
public sealed class RecordingFormatException : NeuronException
{
    /// <summary>Creates an exception without a message.</summary>
    public RecordingFormatException()
    {
    }

    /// <summary>Creates an exception with a message.</summary>
    /// <param name="message">The message that describes the error.</param>
    public RecordingFormatException(string message)
        : base(message)
    {
    }

    /// <summary>Creates an exception with a message and an inner exception.</summary>
    /// <param name="message">The message that describes the error.</param>
    /// <param name="innerException">The exception that caused this one.</param>
    public RecordingFormatException(string message, Exception innerException)
        : base(message, innerException)
    {
    }
}
