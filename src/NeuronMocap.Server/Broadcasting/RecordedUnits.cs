using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Transport;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>Reads every byte of a recording in order of arrival, in units that a client receives whole or not at all.</summary>
/// <remarks>
/// A unit is a packet or a line of text. It includes the bytes before it that are neither, and text directly behind a line. The time of a unit is the
/// arrival of its last byte. Not thread-safe.
/// </remarks>
internal sealed class RecordedUnits : IDisposable
{
    private readonly RecordedEventSource _source;
    private readonly UnitCollector _collector = new();
    private readonly RecordedEventParser _parser;
    private bool _hasEnded;

    public RecordedUnits(RecordedEventSource source)
    {
        _source = source;
        _parser = new RecordedEventParser(source.MaxValues, new SenderFilter([]), _collector);
    }

    public TimeSpan Duration => _source.Duration;

    /// <summary>Whether the last unit is a calculation packet.</summary>
    public bool IsCalculation { get; private set; }

    /// <summary>Maximum size of a unit in bytes.</summary>
    public static int LongestUnit(int maxValues) => UnitCollector.MaxNoiseLength
        + ProtocolConstants.HeaderSize + Math.Max(maxValues * sizeof(float), ProtocolConstants.MaxCommandPayload) + UnitCollector.MaxNoiseLength;

    /// <summary>Reads the next unit.</summary>
    /// <param name="unit">The bytes of the unit, valid until the next call.</param>
    /// <param name="time">The time at which the unit was complete, since the start.</param>
    /// <returns>False at the end.</returns>
    public bool TryRead(out ReadOnlySpan<byte> unit, out TimeSpan time)
    {
        bool isCalculation;
        while (!_collector.TryTake(out unit, out time, out isCalculation))
        {
            if (_hasEnded)
                return false;

            RecordedEvent recorded = _source.Read();
            _hasEnded = recorded.Kind == RecordedEventKind.End;
            bool ends = _hasEnded || _parser.Ends(recorded);
            _collector.Time = recorded.Time;
            if (ends)
                _parser.Close();
            else
                ends = recorded.Kind == RecordedEventKind.Closed;

            _parser.Follow(recorded, timestamp: 0);
            _collector.EndPiece(ends);
        }

        IsCalculation = isCalculation;
        return true;
    }

    /// <summary>Goes back to the start.</summary>
    public void Rewind()
    {
        _source.Seek(TimeSpan.Zero);
        _hasEnded = false;
    }

    public void Dispose() => _source.Dispose();
}
