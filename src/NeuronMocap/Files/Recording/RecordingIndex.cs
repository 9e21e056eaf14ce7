namespace NeuronMocap.Recording;

// The positions of the checkpoints in a file. For a very long file, only every second, fourth, ... checkpoint is kept to limit the memory.
internal sealed class RecordingIndex
{
    private const int MaxPlaces = 4096;

    private readonly List<(long Time, long Offset)> _places = [];
    private int _step = 1;
    private int _passedOver;

    public int Count => _places.Count;

    public long LastOffset => _places[^1].Offset;

    public void Add(long time, long offset)
    {
        if (++_passedOver < _step)
            return;

        _passedOver = 0;
        _places.Add((time, offset));
        if (_places.Count < MaxPlaces)
            return;

        // The first position stays.
        for (int i = 1; i < MaxPlaces / 2; i++)
            _places[i] = _places[2 * i];

        _places.RemoveRange(MaxPlaces / 2, MaxPlaces / 2);
        _step *= 2;
    }

    // Finds the last checkpoint before the time, or else the first. Entries with the time of a checkpoint may stand before it.
    public long Find(long time)
    {
        int low = 0;
        int high = _places.Count;
        while (high - low > 1)
        {
            int middle = (low + high) / 2;
            if (_places[middle].Time < time)
                low = middle;
            else
                high = middle;
        }

        return _places[low].Offset;
    }

    public void Write(ByteBuffer destination)
    {
        destination.AppendNumber(_places.Count);
        (long time, long offset) = (0, 0);
        foreach ((long Time, long Offset) place in _places)
        {
            destination.AppendNumber(place.Time - time);
            destination.AppendNumber(place.Offset - offset);
            (time, offset) = place;
        }
    }

    // Returns false if the payload is not an index for a file of that length.
    public bool TryRead(ReadOnlySpan<byte> payload, long fileLength)
    {
        _places.Clear();
        var cursor = new ByteCursor(payload);
        if (!cursor.TryTakeNumber(out int count) || count is 0 or > MaxPlaces)
            return false;

        (long time, long offset) = (0, 0);
        for (int i = 0; i < count; i++)
        {
            if (!cursor.TryTakeNumber(out long timeDelta) || !cursor.TryTakeNumber(out long offsetDelta)
                || timeDelta > RecordingLayout.MaxTime - time || offsetDelta > fileLength - offset)
            {
                return false;
            }

            (time, offset) = (time + timeDelta, offset + offsetDelta);
            _places.Add((time, offset));
        }

        return true;
    }
}
