namespace NeuronMocap.Bvh;

// Rows of a document that is being read, one after the other in one array, with room for the one that comes next.
internal sealed class BvhRowBuffer(int channelCount)
{
    private const int SmallestGrowth = 256;
    private const int LargestArray = 0x7FFFFFC7;

    private float[] _values = [];
    private float[] _last = [];
    private int _end;

    /// <summary>Where the next row goes.</summary>
    public Span<float> Next
    {
        get
        {
            if (_values.Length - _end >= channelCount)
                return _values.AsSpan(_end, channelCount);

            // Most often nothing follows a full array, which is then not made larger.
            if (_last.Length == 0 && channelCount > 0)
                _last = new float[channelCount];

            return _last;
        }
    }

    /// <summary>Makes room for what is announced, when the text is long enough to hold that many: two bytes a value.</summary>
    public void Reserve(long? frames, long? bytes)
    {
        double announced = (double)(frames ?? 0) * channelCount;
        double most = (bytes / 2) + 1 ?? SmallestGrowth;
        double room = Math.Min(Math.Min(announced, most), LargestArray);
        if (channelCount > 0)
            _values = new float[(int)room / channelCount * channelCount];
    }

    /// <summary>Keeps the row that is in <see cref="Next"/>.</summary>
    public void Keep(BvhTextPosition place)
    {
        if (_values.Length - _end < channelCount)
        {
            Grow(place);
            _last.CopyTo(_values, _end);
        }

        _end += channelCount;
    }

    public float[] ToArray()
    {
        Array.Resize(ref _values, _end);
        return _values;
    }

    private void Grow(BvhTextPosition place)
    {
        long needed = (long)_end + channelCount;
        if (needed > LargestArray)
            throw new BvhFormatException("There are more values than an array holds; a reader can read them row by row.", place.Line, place.Column);

        Array.Resize(ref _values, (int)Math.Min(LargestArray, Math.Max(needed, Math.Max(SmallestGrowth, 2L * _values.Length))));
    }
}
