namespace NeuronMocap.Timing;

// The lower convex hull of points: places of frames in the sequence, and their arrival times in ticks. A frame can be late but never early, so the
// points of an even stream lie on a line or above it, and the longest edge of the hull is this line. Frames that waited, as in the burst when a
// connection opens, are above it and have no influence.
internal sealed class LowerHull
{
    // Half a second of frames needs about ten.
    private const int MaxPoints = 64;

    private (long Place, long Ticks)[] _points = new (long, long)[8];
    private int _count;

    public bool IsFull => _count == MaxPoints;

    // Time since the first point.
    public long ElapsedTicks => _count == 0 ? 0 : _points[_count - 1].Ticks - _points[0].Ticks;

    // The edge that is long both in frames and in time. Its time is 0 if there is no edge.
    public (long Frames, long Ticks) LongestEdge
    {
        get
        {
            (long Frames, long Ticks) longest = default;
            for (int i = 1; i < _count; i++)
            {
                (long frames, long ticks) = (_points[i].Place - _points[i - 1].Place, _points[i].Ticks - _points[i - 1].Ticks);
                if (ticks > 0 && (double)frames * ticks >= (double)longest.Frames * longest.Ticks)
                    longest = (frames, ticks);
            }

            return longest;
        }
    }

    public void Clear() => _count = 0;

    // The place must be higher than that of the last point.
    public void Add(long place, long ticks)
    {
        while (_count > 1 && IsAboveLine(_points[_count - 2], _points[_count - 1], place, ticks))
            _count--;

        if (_count == _points.Length)
            Array.Resize(ref _points, 2 * _count);

        _points[_count++] = (place, ticks);
    }

    // Whether the middle point lies on the line between its neighbours, or above it.
    private static bool IsAboveLine((long Place, long Ticks) first, (long Place, long Ticks) middle, long place, long ticks) =>
        (double)(middle.Place - first.Place) * (ticks - first.Ticks) <= (double)(middle.Ticks - first.Ticks) * (place - first.Place);
}
