using System.Numerics;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>The quantities that a curve shows, in the order in which they are stored.</summary>
internal enum CurveQuantity
{
    /// <summary>Height of the joint in the world, in metres.</summary>
    Height,

    /// <summary>Angle between the bone and its direction in T-pose, relative to its parent, in degrees.</summary>
    Angle,

    /// <summary>Speed of the joint in the world, in metres per second.</summary>
    Speed,
}

/// <summary>Measures height, angle and speed of joints, frame by frame. A frame is ready once the frames after it give its speed.</summary>
/// <remarks>
/// The speed is that between the nearest frames a sixtieth of a second before and after. Over less time the rounding of the last digits, and the
/// jitter of arrival times, would dominate. It is not a number next to a gap.
/// </remarks>
/// <param name="joints">Number of joints.</param>
internal sealed class FrameMeter(int joints)
{
    public const int Quantities = 3;

    private const int Capacity = 256; // frames
    private const double Reach = 1 / 60.0; // s
    private const double Tolerance = 1e-5; // s
    private const double LongestReach = TakeTimes.ShortestGap;
    private const float MetresPerCentimetre = 0.01f;

    private readonly double[] _times = new double[Capacity];
    private readonly Vector3[] _places = new Vector3[Capacity * joints];
    private readonly float[] _angles = new float[Capacity * joints];
    private long _added;
    private long _taken;

    /// <summary>Adds the next frame. At most 100 frames may wait.</summary>
    /// <param name="seconds">Its time.</param>
    /// <param name="places">Positions of the joints in the world, in centimetres.</param>
    /// <param name="angles">Angles of the joints in degrees.</param>
    public void Add(double seconds, ReadOnlySpan<Vector3> places, ReadOnlySpan<float> angles)
    {
        int slot = (int)(_added % Capacity);
        _times[slot] = seconds;
        places[..joints].CopyTo(_places.AsSpan(slot * joints));
        angles[..joints].CopyTo(_angles.AsSpan(slot * joints));
        _added++;
    }

    /// <summary>Takes the next frame that is ready.</summary>
    /// <param name="atEnd">Whether no frame follows.</param>
    /// <param name="seconds">Its time.</param>
    /// <param name="values">Receives the quantities of the first joint, then of the next.</param>
    /// <returns>False if no frame is ready.</returns>
    public bool TryTake(bool atEnd, out double seconds, Span<float> values)
    {
        seconds = 0;
        if (_taken == _added)
            return false;

        seconds = TimeOf(_taken);
        long after = _taken;
        while (after < _added - 1 && TimeOf(after) < seconds + Reach - Tolerance)
            after++;

        bool isKnown = TimeOf(after) >= seconds + Reach - Tolerance;
        if (!isKnown && !atEnd && _added - _taken < Capacity / 2)
            return false;

        long before = _taken;
        long oldest = Math.Max(0, _added - Capacity);
        while (before > oldest && TimeOf(before) > seconds - Reach + Tolerance)
            before--;

        Write(Nearest(before, 1), Nearest(after, -1), values);
        _taken++;
        return true;
    }

    // A frame beyond a gap says nothing about the speed.
    private long Nearest(long frame, int step)
    {
        while (frame != _taken && Math.Abs(TimeOf(frame) - TimeOf(_taken)) > LongestReach)
            frame += step;

        return frame;
    }

    private void Write(long before, long after, Span<float> values)
    {
        double seconds = TimeOf(after) - TimeOf(before);
        int slot = (int)(_taken % Capacity) * joints;
        for (int joint = 0; joint < joints; joint++)
        {
            float distance = Vector3.Distance(_places[((int)(before % Capacity) * joints) + joint], _places[((int)(after % Capacity) * joints) + joint]);
            Span<float> value = values.Slice(joint * Quantities, Quantities);
            value[(int)CurveQuantity.Height] = _places[slot + joint].Y * MetresPerCentimetre;
            value[(int)CurveQuantity.Angle] = _angles[slot + joint];
            value[(int)CurveQuantity.Speed] = seconds > 0 ? (float)(distance / seconds) * MetresPerCentimetre : float.NaN;
        }
    }

    private double TimeOf(long frame) => _times[frame % Capacity];
}
