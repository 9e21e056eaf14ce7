using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

public sealed class UnityAxesTests
{
    public static TheoryData<RotationOrder> Orders => [.. Enum.GetValues<RotationOrder>()];

    // The results of the vendor's scripts for the same values.
    [Fact]
    public void Vectors_match_the_vendors()
    {
        AssertNear(new Vector3(-1, 0.9f, 0.5f), UnityAxes.ToUnityPosition(new Vector3(100, 90, 50)), 1e-7f);
        Assert.Equal(new Vector3(0, -30, 0), UnityAxes.ToUnityEuler(new Vector3(30, 0, 0), RotationOrder.YXZ));
        Assert.Equal(new Vector3(20, -10, -40), UnityAxes.ToUnityEuler(new Vector3(10, 20, 40), RotationOrder.YXZ));
        AssertNear(new Vector3(20, -10, -40), UnityAxes.ToUnityEuler(UnityAxes.ToUnityRotation(new Vector3(10, 20, 40), RotationOrder.YXZ)), 1e-4f);
    }

    [Fact]
    public void Left_stays_left()
    {
        Vector3 hand = UnityAxes.ToUnityPosition(DefaultOffsets.Get(Bone.LeftHand));
        Assert.True(hand.X < 0);
        Assert.Equal(-Vector3.UnitX, UnityAxes.Mirror(Vector3.UnitX));
    }

    [Theory]
    [MemberData(nameof(Orders))]
    public void A_mirrored_rotation_turns_mirrored_points(RotationOrder order)
    {
        var random = new Random(1);
        for (int i = 0; i < 500; i++)
        {
            Vector3 degrees = Angles(random);
            Affine expected = Affine.MirrorX * ReferenceOf(degrees, order) * Affine.MirrorX;
            Assert.True(expected.AngleTo(UnityAxes.ToUnityRotation(degrees, order)) < 1e-6, $"{degrees}");
            Assert.True(expected.AngleTo(UnityAxes.ToUnityRotation(EulerAngles.ToQuaternion(degrees, order))) < 1e-6, $"{degrees}");
        }
    }

    [Theory]
    [MemberData(nameof(Orders))]
    public void Unitys_Euler_angles_are_the_same_rotation(RotationOrder order)
    {
        var random = new Random(2);
        for (int i = 0; i < 500; i++)
        {
            Vector3 degrees = Angles(random);
            Vector3 unity = UnityAxes.ToUnityEuler(degrees, order);

            // Unity turns about Z, then X, then Y.
            Affine turned = Affine.Turned([0, 1, 0], Radians(unity.Y)) * Affine.Turned([1, 0, 0], Radians(unity.X)) * Affine.Turned([0, 0, 1], Radians(unity.Z));
            Affine expected = Affine.MirrorX * ReferenceOf(degrees, order) * Affine.MirrorX;
            Assert.True(turned.AngleTo(expected) < 2e-6, $"{degrees} to {unity}");
            Assert.True(ReferenceOf(UnityAxes.FromUnityEuler(unity, order), order).AngleTo(ReferenceOf(degrees, order)) < 4e-6, $"{degrees} back from {unity}");
        }
    }

    [Fact]
    public void The_streams_order_keeps_its_angles()
    {
        var degrees = new Vector3(-350.5f, 179.25f, 721);
        Assert.Equal(new Vector3(179.25f, 350.5f, -721), UnityAxes.ToUnityEuler(degrees, RotationOrder.YXZ));
        Assert.Equal(degrees, UnityAxes.FromUnityEuler(new Vector3(179.25f, 350.5f, -721), RotationOrder.YXZ));
    }

    [Fact]
    public void The_conversion_is_its_own_inverse()
    {
        var random = new Random(3);
        for (int i = 0; i < 200; i++)
        {
            Vector3 place = RandomPoses.Direction(random) * 300;
            Quaternion turn = RandomPoses.Turn(random);
            AssertNear(place, UnityAxes.FromUnityPosition(UnityAxes.ToUnityPosition(place)), 1e-4f);
            Assert.Equal(turn, UnityAxes.FromUnityRotation(UnityAxes.ToUnityRotation(turn)));
        }
    }

    [Fact]
    public void An_unknown_order_is_refused() =>
        Assert.Throws<ArgumentOutOfRangeException>(() => UnityAxes.ToUnityEuler(Vector3.Zero, (RotationOrder)6));

    private static Affine ReferenceOf(Vector3 degrees, RotationOrder order)
    {
        string axes = order.ToString();
        return Turn(axes[0], degrees.X) * Turn(axes[1], degrees.Y) * Turn(axes[2], degrees.Z);
    }

    private static Affine Turn(char axis, float degrees) => Affine.Turned([axis == 'X' ? 1 : 0, axis == 'Y' ? 1 : 0, axis == 'Z' ? 1 : 0], Radians(degrees));

    private static double Radians(float degrees) => degrees * Math.PI / 180;

    private static Vector3 Angles(Random random) => new(Angle(random), Angle(random), Angle(random));

    private static float Angle(Random random) => (random.NextSingle() - 0.5f) * 360;

    private static void AssertNear(Vector3 expected, Vector3 actual, float tolerance) =>
        Assert.True(Vector3.Distance(expected, actual) <= tolerance, $"{expected} and {actual}");
}
