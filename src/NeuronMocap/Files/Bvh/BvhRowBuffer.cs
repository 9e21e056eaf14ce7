namespace NeuronMocap.Bvh;

// Holds the rows of a document that is being read, one after the other in one array, with room for the next row.
internal sealed class BvhRowBuffer(int channelCount)
{
    private const int SmallestGrowth = 256;
    private const int LargestArray = 0x7FFFFFC7;

    private float[] _values = [];
    private float[] _last = [];
    private int _end;

    /// <summary>The memory for the next row.</summary>
    public Span<float> Next
    {
        get
        {
            if (_values.Length - _end >= channelCount)
                return _values.AsSpan(_end, channelCount);

            // Usually, a full array is complete and does not have to grow.
            if (_last.Length == 0 && channelCount > 0)
                _last = new float[channelCount];

            return _last;
        }
    }

    /// <summary>Allocates memory for the declared frames, limited by the length of the text: a value needs at least two bytes.</summary>
    public void Reserve(long? frames, long? bytes)
    {
        double announced = (double)(frames ?? 0) * channelCount;
        double most = (bytes / 2) + 1 ?? SmallestGrowth;
        double room = Math.Min(Math.Min(announced, most), LargestArray);
        if (channelCount > 0)
            _values = new float[(int)room / channelCount * channelCount];
    }

    /// <summary>Keeps the row in <see cref="Next"/>.</summary>
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
            throw new BvhFormatException("The file has more values than an array can hold; read it row by row instead.", place.Line, place.Column);

        Array.Resize(ref _values, (int)Math.Min(LargestArray, Math.Max(needed, Math.Max(SmallestGrowth, 2L * _values.Length))));
    }
}
