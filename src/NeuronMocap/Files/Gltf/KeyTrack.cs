using System.Numerics;
using System.Runtime.InteropServices;

namespace NeuronMocap.Gltf;

// The keys of one property of a bone. Without a reducer, it has a key at each time of the animation, unless its value never changes.
internal sealed class KeyTrack(KeySpool spool, int width, KeyReducer? reducer, float tolerance)
{
    private readonly FloatList _values = new(spool);
    private readonly FloatList? _times = reducer is null ? null : new FloatList(spool);
    private Vector4 _first;
    private long _frames;

    // Whether one key stands for all.
    public bool IsConstant { get; private set; } = true;

    public Vector4 First => _first;

    public long KeyCount => IsConstant ? 1 : _values.Count / width;

    private int ValueSize => width * sizeof(float);

    // Null if the keys are at each time of the animation.
    public FloatList? Times => IsConstant ? null : _times;

    public void Add(float time, Vector4 value)
    {
        if (_frames++ == 0)
            _first = value;

        if (reducer is not null)
        {
            IsConstant &= reducer.Distance(_first, value) <= tolerance;
            if (reducer.Add(time, value, out (float Time, Vector4 Value) key))
                AddKey(key);
        }
        else if (!IsConstant)
        {
            AddValue(value);
        }
        else if (value == _first)
        {
            spool.Promised += ValueSize;
        }
        else
        {
            IsConstant = false;
            AddConstant();
            AddValue(value);
        }
    }

    // After the last frame, once.
    public void Complete()
    {
        if (reducer is not null && reducer.TryEnd(out (float Time, Vector4 Value) key))
            AddKey(key);
    }

    public void CopyValuesTo(Stream output)
    {
        if (!IsConstant)
        {
            _values.CopyTo(output);
            return;
        }

        Span<float> values = stackalloc float[4];
        output.Write(MemoryMarshal.AsBytes(Components(_first, values)).ToArray(), 0, ValueSize);
    }

    private void AddConstant()
    {
        spool.Promised -= ValueSize * (_frames - 1);
        Span<float> values = stackalloc float[4];
        _values.AddRepeated(Components(_first, values), _frames - 1);
    }

    private void AddKey((float Time, Vector4 Value) key)
    {
        _times!.Add(key.Time);
        AddValue(key.Value);
    }

    private void AddValue(Vector4 value)
    {
        Span<float> values = stackalloc float[4];
        _values.Add(Components(value, values));
    }

    private ReadOnlySpan<float> Components(Vector4 value, Span<float> values)
    {
        (values[0], values[1], values[2], values[3]) = (value.X, value.Y, value.Z, value.W);
        return values[..width];
    }
}
