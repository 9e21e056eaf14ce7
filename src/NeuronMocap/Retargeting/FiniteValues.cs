using System.Numerics;

namespace NeuronMocap.Retargeting;

internal static class FiniteValues
{
    // Infinity minus infinity is not a number either.
    public static bool IsFinite(float value) => value - value == 0;

    public static bool IsFinite(Vector3 value) => value - value == Vector3.Zero;

    public static bool IsFinite(Quaternion value) => value - value == default;
}
