namespace NeuronMocap.Bvh;

/// <summary>A file is not BVH, or so damaged that no reading of it is right.</summary>
public sealed class BvhFormatException : NeuronException
{
    /// <summary>Makes an exception without a message.</summary>
    public BvhFormatException()
    {
    }

    /// <summary>Makes an exception.</summary>
    /// <param name="message">What is wrong.</param>
    public BvhFormatException(string message)
        : base(message)
    {
    }

    /// <summary>Makes an exception that another one caused.</summary>
    /// <param name="message">What is wrong.</param>
    /// <param name="innerException">The cause.</param>
    public BvhFormatException(string message, Exception innerException)
        : base(message, innerException)
    {
    }

    /// <summary>Makes an exception; the place becomes part of its message.</summary>
    /// <param name="message">What is wrong.</param>
    /// <param name="line">Line of the file, from 1.</param>
    /// <param name="column">Byte of that line, from 1.</param>
    public BvhFormatException(string message, int line, int column)
        : base($"line {line}, column {column}: {message}")
    {
        Line = line;
        Column = column;
    }

    /// <summary>Line of the file, from 1; 0 when there is none to name.</summary>
    public int Line { get; }

    /// <summary>Byte of that line, from 1; 0 when there is none to name.</summary>
    public int Column { get; }
}
