namespace NeuronMocap.Bvh;

/// <summary>The exception that is thrown when a file is not BVH, or is too damaged to be read correctly.</summary>
public sealed class BvhFormatException : NeuronException
{
    /// <summary>Creates an exception without a message.</summary>
    public BvhFormatException()
    {
    }

    /// <summary>Creates an exception with a message.</summary>
    /// <param name="message">The message that describes the error.</param>
    public BvhFormatException(string message)
        : base(message)
    {
    }

    /// <summary>Creates an exception with a message and an inner exception.</summary>
    /// <param name="message">The message that describes the error.</param>
    /// <param name="innerException">The exception that caused this one.</param>
    public BvhFormatException(string message, Exception innerException)
        : base(message, innerException)
    {
    }

    /// <summary>Creates an exception with a message and a position, which is added to the message.</summary>
    /// <param name="message">The message that describes the error.</param>
    /// <param name="line">Line of the file, from 1.</param>
    /// <param name="column">Byte within that line, from 1.</param>
    public BvhFormatException(string message, int line, int column)
        : base($"line {line}, column {column}: {message}")
    {
        Line = line;
        Column = column;
    }

    /// <summary>Line of the file, from 1; 0 when unknown.</summary>
    public int Line { get; }

    /// <summary>Byte within that line, from 1; 0 when unknown.</summary>
    public int Column { get; }
}
