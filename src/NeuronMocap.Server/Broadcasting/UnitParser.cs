using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Transport;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>Cuts the bytes of connections into units that a client receives whole or not at all.</summary>
/// <remarks>
/// A unit is a packet or a line of text. It includes the bytes before it that are neither, and text directly behind a line. The time of a unit is the
/// arrival of its last byte. Not thread-safe. Does not allocate once its buffers have grown.
/// </remarks>
internal sealed class UnitParser
{
    private readonly UnitCollector _collector;
    private readonly RecordedEventParser _parser;

    /// <summary>Creates a parser.</summary>
    /// <param name="maxValues">The most values that a packet may have.</param>
    /// <param name="keepsIncomplete">Whether the start of a packet that was cut off is kept. Otherwise it is counted.</param>
    public UnitParser(int maxValues, bool keepsIncomplete)
    {
        _collector = new UnitCollector(keepsIncomplete);
        _parser = new RecordedEventParser(maxValues, new SenderFilter([]), _collector);
    }

    /// <summary>Number of packets that were cut off and not kept. Thread-safe.</summary>
    public long IncompletePackets => _collector.IncompletePackets;

    /// <summary>Maximum size of a unit in bytes.</summary>
    public static int LongestUnit(int maxValues) => UnitCollector.MaxNoiseLength
        + ProtocolConstants.HeaderSize + Math.Max(maxValues * sizeof(float), ProtocolConstants.MaxCommandPayload) + UnitCollector.MaxNoiseLength;

    /// <summary>Takes the next event of the connections. All units of the previous event must be taken before.</summary>
    public void Follow(in RecordedEvent received)
    {
        bool ends = received.Kind == RecordedEventKind.End || _parser.Ends(received);
        _collector.Time = received.Time;
        if (ends)
            _parser.Close();
        else
            ends = received.Kind == RecordedEventKind.Closed;

        _parser.Follow(received, timestamp: 0);
        _collector.EndPiece(ends);
    }

    /// <summary>Takes the next unit.</summary>
    /// <param name="unit">The bytes of the unit, valid until the next event.</param>
    /// <param name="time">The time at which the unit was complete.</param>
    /// <param name="isCalculation">Whether the unit is a calculation packet.</param>
    /// <returns>False if no unit is complete.</returns>
    public bool TryTake(out ReadOnlySpan<byte> unit, out TimeSpan time, out bool isCalculation) => _collector.TryTake(out unit, out time, out isCalculation);
}
