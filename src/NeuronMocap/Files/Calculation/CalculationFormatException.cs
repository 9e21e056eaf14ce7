namespace NeuronMocap.Calculation;

/// <summary>The exception that is thrown when a file is not a calculation export, or has a defect and is read strictly.</summary>
public sealed class CalculationFormatException : NeuronException
{
    /// <summary>Creates an exception without a message.</summary>
    public CalculationFormatException()
    {
    }

    /// <summary>Creates an exception with a message.</summary>
    /// <param name="message">The message that describes the error.</param>
    public CalculationFormatException(string message)
        : base(message)
    {
    }

    /// <summary>Creates an exception with a message and an inner exception.</summary>
    /// <param name="message">The message that describes the error.</param>
    /// <param name="innerException">The exception that caused this one.</param>
    public CalculationFormatException(string message, Exception innerException)
        : base(message, innerException)
    {
    }

    /// <summary>Creates an exception with a message and a position, which is added to the message.</summary>
    /// <param name="message">The message that describes the error.</param>
    /// <param name="line">Line of the file, from 1.</param>
    /// <param name="column">Byte within that line, from 1.</param>
    public CalculationFormatException(string message, int line, int column)
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
