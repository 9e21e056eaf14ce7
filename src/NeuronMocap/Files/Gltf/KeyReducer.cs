using System.Numerics;
using NeuronMocap.Motion;

namespace NeuronMocap.Gltf;

// Chooses keys so that a straight line between two keys passes each frame within a tolerance. Time and memory for a frame are constant.
//
// Frames since the last key restrict the slope of the line to a box. A frame is kept as the end of the line while its slope lies in the box of the
// frames before it. For rotations, the line is a rotation vector relative to the last key: the angle between two rotations is at most the distance
// of their rotation vectors, so the bound holds for slerp as well.
internal sealed class KeyReducer(float tolerance, bool isRotation)
{
    // Above, the shorter of two rotations could change its side.
    private const float LongestTurn = 1.5f;

    // A box of this half width lies in a ball of the tolerance.
    private readonly float _margin = tolerance / MathF.Sqrt(3);

    private bool _hasKey;
    private bool _hasEnd;
    private float _keyTime;
    private Vector4 _key;
    private float _endTime;
    private Vector4 _end;
    private Vector3 _low;
    private Vector3 _high;

    // Returns true if a key is due, at most one for each frame.
    public bool Add(float time, Vector4 value, out (float Time, Vector4 Value) key)
    {
        bool isFirst = !_hasKey;
        key = (time, value);
        if (isFirst)
        {
            Begin(time, value);
            return true;
        }

        Vector3 change = Change(value);
        Vector3 slope = change / (time - _keyTime);
        bool isDue = _hasEnd && !(IsInBox(slope) && (!isRotation || change.Length() < LongestTurn));
        if (isDue)
        {
            key = (_endTime, _end);
            Begin(_endTime, _end);
            slope = Change(value) / (time - _keyTime);
        }

        var margin = new Vector3(_margin / (time - _keyTime));
        _low = Vector3.Max(_low, slope - margin);
        _high = Vector3.Min(_high, slope + margin);
        (_hasEnd, _endTime, _end) = (true, time, value);
        return isDue;
    }

    // Returns false if the last frame is a key already.
    public bool TryEnd(out (float Time, Vector4 Value) key)
    {
        key = (_endTime, _end);
        return _hasEnd;
    }

    // In radians, or in the unit of positions.
    public float Distance(Vector4 from, Vector4 to) => ChangeBetween(from, to).Length();

    private void Begin(float time, Vector4 value)
    {
        (_hasKey, _keyTime, _key, _hasEnd) = (true, time, value, false);
        _low = new Vector3(float.NegativeInfinity);
        _high = new Vector3(float.PositiveInfinity);
    }

    private bool IsInBox(Vector3 slope) =>
        slope.X >= _low.X && slope.Y >= _low.Y && slope.Z >= _low.Z && slope.X <= _high.X && slope.Y <= _high.Y && slope.Z <= _high.Z;

    private Vector3 Change(Vector4 value) => ChangeBetween(_key, value);

    private Vector3 ChangeBetween(Vector4 from, Vector4 to) => isRotation
        ? QuaternionMath.TurnBetween(ToQuaternion(from), ToQuaternion(to))
        : new Vector3(to.X - from.X, to.Y - from.Y, to.Z - from.Z);

    private static Quaternion ToQuaternion(Vector4 value) => new(value.X, value.Y, value.Z, value.W);
}
