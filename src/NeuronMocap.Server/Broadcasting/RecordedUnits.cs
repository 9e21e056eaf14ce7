using NeuronMocap.Recording;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>Reads every byte of a recording in order of arrival, in units that a client receives whole or not at all. Not thread-safe.</summary>
internal sealed class RecordedUnits(RecordedEventSource source) : IDisposable
{
    private readonly UnitParser _parser = new(source.MaxValues, keepsIncomplete: true);
    private int _next;
    private bool _hasEnded;

    public TimeSpan Duration => source.Duration;

    /// <summary>Whether the last unit is a calculation packet.</summary>
    public bool IsCalculation { get; private set; }

    /// <summary>Reads the next unit.</summary>
    /// <param name="unit">The bytes of the unit, valid until the next call.</param>
    /// <param name="time">The time at which the unit was complete, since the start.</param>
    /// <returns>False at the end.</returns>
    public bool TryRead(out ReadOnlySpan<byte> unit, out TimeSpan time)
    {
        UnitBatch units = _parser.Units;
        while (_next == units.Count)
        {
            if (_hasEnded)
            {
                unit = default;
                time = default;
                return false;
            }

            RecordedEvent recorded = source.Read();
            _hasEnded = recorded.Kind == RecordedEventKind.End;
            _parser.Follow(recorded);
            _next = 0;
        }

        unit = units.BytesOf(_next);
        time = units.TimeOf(_next);
        IsCalculation = units.IsCalculation(_next++);
        return true;
    }

    /// <summary>Goes back to the start.</summary>
    public void Rewind()
    {
        source.Seek(TimeSpan.Zero);
        _hasEnded = false;
    }

    public void Dispose() => source.Dispose();
}
