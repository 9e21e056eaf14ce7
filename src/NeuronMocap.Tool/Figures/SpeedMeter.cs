using System.Numerics;

namespace NeuronMocap.Tool.Figures;

/// <summary>Measures the speed of a point from its positions some frames before and after.</summary>
/// <remarks>Over less than a thirtieth of a second, the rounding of the values' last digits would dominate the speed.</remarks>
internal sealed class SpeedMeter(double frameRate, bool horizontal)
{
    private const double LongestReach = 100_000; // frames

    private readonly int _reach = (int)Math.Clamp(Math.Round(frameRate / 60), 1, LongestReach);
    private readonly Queue<Vector3> _places = new();
    private long _next;

    /// <summary>Adds the next position.</summary>
    /// <returns>The frame whose speed is now known, and its speed per second; null at the start.</returns>
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
