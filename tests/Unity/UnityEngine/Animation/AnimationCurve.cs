namespace UnityEngine;

public class AnimationCurve
{
    private readonly List<Keyframe> _keys;

    public AnimationCurve()
        : this([])
    {
    }

    public AnimationCurve(params Keyframe[] keys) => _keys = [.. keys.OrderBy(static key => key.time)];

    public Keyframe[] keys
    {
        get => [.. _keys];

        set
        {
            _keys.Clear();
            _keys.AddRange(value.OrderBy(static key => key.time));
        }
    }

    public int length => _keys.Count;

    public Keyframe this[int index] => _keys[index];

    public static AnimationCurve Linear(float timeStart, float valueStart, float timeEnd, float valueEnd)
    {
        float slope = (valueEnd - valueStart) / (timeEnd - timeStart);
        return new AnimationCurve(new Keyframe(timeStart, valueStart, 0, slope), new Keyframe(timeEnd, valueEnd, slope, 0));
    }

    public static AnimationCurve EaseInOut(float timeStart, float valueStart, float timeEnd, float valueEnd) =>
        new(new Keyframe(timeStart, valueStart, 0, 0), new Keyframe(timeEnd, valueEnd, 0, 0));

    public static AnimationCurve Constant(float timeStart, float timeEnd, float value) => Linear(timeStart, value, timeEnd, value);

    public int AddKey(float time, float value) => AddKey(new Keyframe(time, value));

    /// <returns>The index of the key, or -1 if there is already a key at that time.</returns>
    public int AddKey(Keyframe key)
    {
        int index = _keys.FindIndex(other => other.time >= key.time);
        if (index >= 0 && _keys[index].time == key.time)
            return -1;

        if (index < 0)
            index = _keys.Count;

        _keys.Insert(index, key);
        return index;
    }

    public int MoveKey(int index, Keyframe key)
    {
        _keys.RemoveAt(index);
        return AddKey(key);
    }

    public void RemoveKey(int index) => _keys.RemoveAt(index);

    /// <summary>Hermite interpolation between two keys. Outside, it returns the values of the ends.</summary>
    public float Evaluate(float time)
    {
        if (_keys.Count == 0)
            return 0;

        int next = _keys.FindIndex(key => key.time > time);
        if (next <= 0)
            return _keys[next == 0 ? 0 : _keys.Count - 1].value;

        Keyframe from = _keys[next - 1];
        Keyframe to = _keys[next];
        if (float.IsInfinity(from.outTangent) || float.IsInfinity(to.inTangent))
            return from.value;

        float span = to.time - from.time;
        float t = (time - from.time) / span;
        float squared = t * t;
        float cubed = squared * t;
        return (((2 * cubed) - (3 * squared) + 1) * from.value) + ((cubed - (2 * squared) + t) * span * from.outTangent)
            + (((-2 * cubed) + (3 * squared)) * to.value) + ((cubed - squared) * span * to.inTangent);
    }

    public void SmoothTangents(int index, float weight)
    {
        Keyframe key = _keys[index];
        Keyframe before = _keys[Math.Max(index - 1, 0)];
        Keyframe after = _keys[Math.Min(index + 1, _keys.Count - 1)];
        float slope = after.time > before.time ? (after.value - before.value) / (after.time - before.time) : 0;
        key.inTangent = slope;
        key.outTangent = slope;
        _keys[index] = key;
    }
}

[Serializable]
public struct Keyframe(float time, float value, float inTangent, float outTangent)
{
    public Keyframe(float time, float value)
        : this(time, value, 0, 0)
    {
    }

    public float time { get; set; } = time;

    public float value { get; set; } = value;

    public float inTangent { get; set; } = inTangent;

    public float outTangent { get; set; } = outTangent;
}
