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

    /// <summary>The units that the last event completed, valid until the next event.</summary>
    public UnitBatch Units => _collector.Units;

    /// <summary>Maximum size of a unit in bytes.</summary>
    public static int LongestUnit(int maxValues) => UnitCollector.MaxNoiseLength
        + ProtocolConstants.HeaderSize + Math.Max(maxValues * sizeof(float), ProtocolConstants.MaxCommandPayload) + UnitCollector.MaxNoiseLength;

    /// <summary>Takes the next event of the connections, and removes the units of the previous one.</summary>
    public void Follow(in RecordedEvent received)
    {
        Units.RemoveUnits();
        bool ends = received.Kind == RecordedEventKind.End || _parser.Ends(received);
        _collector.Time = received.Time;
        if (ends)
            _parser.Close();
        else
            ends = received.Kind == RecordedEventKind.Closed;

        _parser.Follow(received, timestamp: 0);
        _collector.EndPiece(ends);
    }
}
