using System.Numerics;

namespace NeuronMocap.Tests.Retargeting;

internal static class RandomVectors
{
    public static float Range(this Random random, float from, float to) => from + ((to - from) * random.NextSingle());

    public static Vector3 InBox(this Random random, float half) => new(random.Range(-half, half), random.Range(-half, half), random.Range(-half, half));

    // Equally likely in every direction: a point of a cube that is inside the ball.
    public static Vector3 Direction(this Random random)
    {
        Vector3 point;
        do
            point = random.InBox(1);
        while (point.LengthSquared() is > 1 or < 1e-4f);

        return Vector3.Normalize(point);
    }

    public static Quaternion Rotation(this Random random) =>
        Quaternion.CreateFromAxisAngle(random.Direction(), random.Range(0, 2 * MathF.PI));
}
