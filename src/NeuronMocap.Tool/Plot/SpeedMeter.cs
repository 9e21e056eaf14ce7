using System.Numerics;

namespace NeuronMocap.Tool.Plot;

/// <summary>
/// The speed of a point, from its places some frames before and after: over less than a thirtieth of a second the steps of the values' last digits
/// would be most of it.
/// </summary>
internal sealed class SpeedMeter(double frameRate, bool horizontal)
{
    private const double LongestReach = 100_000; // frames

    private readonly int _reach = (int)Math.Clamp(Math.Round(frameRate / 60), 1, LongestReach);
    private readonly Queue<Vector3> _places = new();
    private long _next;

    /// <summary>Takes the next place.</summary>
    /// <returns>The frame that can now be told, and its speed per second; null at the beginning.</returns>
    public (long Frame, float Speed)? Add(Vector3 place)
    {
        place = horizontal ? place with { Y = 0 } : place;
        _places.Enqueue(place);
        _next++;
        if (_places.Count <= 2 * _reach)
            return null;

        Vector3 before = _places.Dequeue();
        double seconds = 2.0 * _reach / frameRate;
        return (_next - 1 - _reach, (float)(Vector3.Distance(before, place) / seconds));
    }
}
