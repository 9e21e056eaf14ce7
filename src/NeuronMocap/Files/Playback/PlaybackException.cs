namespace NeuronMocap.Recording;

/// <summary>The exception that is thrown when a file cannot be played, because it is neither a recording nor a dump of a stream.</summary>
public sealed class PlaybackException : NeuronException
{
    /// <summary>Creates an exception without a message.</summary>
    public PlaybackException()
    {
    }

    /// <summary>Creates an exception with a message.</summary>
    /// <param name="message">The message that describes the error.</param>
    public PlaybackException(string message)
        : base(message)
    {
    }

    /// <summary>Creates an exception with a message and an inner exception.</summary>
    /// <param name="message">The message that describes the error.</param>
    /// <param name="innerException">The exception that caused this one.</param>
    public PlaybackException(string message, Exception innerException)
        : base(message, innerException)
    {
    }
}
