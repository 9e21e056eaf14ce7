namespace NeuronMocap.Recording;

/// <summary>A file holds nothing that can be played: it is neither a recording nor a dump of a stream.</summary>
public sealed class PlaybackException : NeuronException
{
    /// <summary>Makes an exception without a message.</summary>
    public PlaybackException()
    {
    }

    /// <summary>Makes an exception.</summary>
    /// <param name="message">What is wrong.</param>
    public PlaybackException(string message)
        : base(message)
    {
    }

    /// <summary>Makes an exception that another one caused.</summary>
    /// <param name="message">What is wrong.</param>
    /// <param name="innerException">The cause.</param>
    public PlaybackException(string message, Exception innerException)
        : base(message, innerException)
    {
    }
}
