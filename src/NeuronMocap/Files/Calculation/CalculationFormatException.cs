namespace NeuronMocap.Calculation;

/// <summary>A file is no calculation export, or was to be read strictly and is not as it should be.</summary>
public sealed class CalculationFormatException : NeuronException
{
    /// <summary>Makes an exception without a message.</summary>
    public CalculationFormatException()
    {
    }

    /// <summary>Makes an exception.</summary>
    /// <param name="message">What is wrong.</param>
    public CalculationFormatException(string message)
        : base(message)
    {
    }

    /// <summary>Makes an exception that another one caused.</summary>
    /// <param name="message">What is wrong.</param>
    /// <param name="innerException">The cause.</param>
    public CalculationFormatException(string message, Exception innerException)
        : base(message, innerException)
    {
    }

    /// <summary>Makes an exception; the place becomes part of its message.</summary>
    /// <param name="message">What is wrong.</param>
    /// <param name="line">Line of the file, from 1.</param>
    /// <param name="column">Byte of that line, from 1.</param>
    public CalculationFormatException(string message, int line, int column)
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
