using System.Numerics;
using NeuronMocap.Gltf;

namespace NeuronMocap.Tests.Gltf;

public sealed class KeyReducerTests
{
    [Theory, InlineData(0.1f), InlineData(1f), InlineData(10f)]
    public void Every_rotation_is_within_the_angle(float degrees)
    {
        var random = new Random(7);
        float tolerance = degrees * MathF.PI / 180;
        Quaternion[] frames = new Quaternion[2000];
        Quaternion current = Quaternion.Identity;
        for (int i = 0; i < frames.Length; i++)
        {
            // Rests, smooth turns, trembling, and jumps to anywhere.
            float speed = (i / 100 % 4) switch { 0 => 0, 1 => 0.02f, 2 => 0.002f * (float)random.NextDouble(), _ => i % 10 == 0 ? 3 : 0 };
            Vector3 axis = i / 100 % 4 == 1 ? Vector3.UnitY : Direction(random);
            frames[i] = current = Quaternion.Normalize(current * Quaternion.CreateFromAxisAngle(axis, speed));
        }

        var keys = Reduce(new KeyReducer(tolerance, isRotation: true), [.. frames.Select(static turn => new Vector4(turn.X, turn.Y, turn.Z, turn.W))]);

        Assert.InRange(keys.Count, 2, 1500);
        for (int i = 0, key = 0; i < frames.Length; i++)
        {
            while (keys[key + 1].Time < i)
                key++;

            (float from, Vector4 a) = keys[key];
            (float to, Vector4 b) = keys[key + 1];
            Quaternion shown = Quaternion.Slerp(Turn(a), Turn(b), (i - from) / (to - from));
            Quaternion rest = Quaternion.Conjugate(shown) * frames[i];
            double angle = 2 * Math.Atan2(new Vector3(rest.X, rest.Y, rest.Z).Length(), Math.Abs(rest.W));
            Assert.True(angle <= (tolerance * 1.001) + 1e-5, $"Frame {i}: {angle * 180 / Math.PI} degrees.");
        }
    }

    [Fact]
    public void A_line_needs_two_keys_and_a_corner_one_more()
    {
        Vector4[] frames = [.. Enumerable.Range(0, 1000).Select(static i => new Vector4(i < 500 ? i : 1000 - i, 2 * i, 3, 0))];

        List<(float Time, Vector4 Value)> keys = Reduce(new KeyReducer(0.01f, isRotation: false), frames);

        Assert.Equal([0, 500, 999], keys.Select(static key => key.Time));
        Assert.All(keys, key => Assert.Equal(frames[(int)key.Time], key.Value));
    }

    private static List<(float Time, Vector4 Value)> Reduce(KeyReducer reducer, Vector4[] frames)
    {
        List<(float Time, Vector4 Value)> keys = [];
        for (int i = 0; i < frames.Length; i++)
        {
            if (reducer.Add(i, frames[i], out (float Time, Vector4 Value) key))
                keys.Add(key);
        }

        Assert.True(reducer.TryEnd(out (float Time, Vector4 Value) last));
        keys.Add(last);
        return keys;
    }

    private static Vector3 Direction(Random random) =>
        Vector3.Normalize(new Vector3((float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.49f));

    private static Quaternion Turn(Vector4 value) => new(value.X, value.Y, value.Z, value.W);
}
