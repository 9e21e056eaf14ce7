namespace NeuronMocap.Recording;

/// <summary>A connection, or a bound UDP port, as a recording knows it.</summary>
/// <param name="Number">Its number in the recording, from 0; no two have the same.</param>
/// <param name="Transport">How the bytes came.</param>
/// <param name="Local">This computer's end point, such as "192.168.1.5:50412"; empty when it is not known.</param>
/// <param name="Remote">The server's end point; empty when it is not known, and over UDP, where every sender has its own.</param>
public sealed record RecordedConnection(int Number, TransportKind Transport, string Local, string Remote)
{
    /// <summary>
    /// Whether it stood before: what it brought until then is not in the recording, or lies before the place where reading began or in an
    /// earlier file.
    /// </summary>
    public bool WasOpen { get; init; }

    /// <summary>
    /// Whether it is the connection of <see cref="NeuronReaderOptions.CalculationPort"/>, which stands beside another one. Only calculation data of it counts.
    /// </summary>
    public bool IsCalculation { get; init; }
}
