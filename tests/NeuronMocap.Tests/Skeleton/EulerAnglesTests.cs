using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Skeleton;

public sealed class EulerAnglesTests
{
    private const double Tolerance = 2e-6;

    public static TheoryData<RotationOrder> Orders => [.. Enum.GetValues<RotationOrder>()];

    [Fact]
    public void The_orders_have_the_vendors_numbers()
    {
        IEnumerable<RotationOrder> byNumber = Enumerable.Range(0, 6).Select(number => (RotationOrder)number);
        Assert.Equal(
            [RotationOrder.XZY, RotationOrder.YXZ, RotationOrder.XYZ, RotationOrder.YZX, RotationOrder.ZXY, RotationOrder.ZYX],
            byNumber);
    }

    // One quarter turn moves an axis to the next: Y moves Z to X, X moves Y to Z, Z moves X to Y.
    [Theory]
    [InlineData(RotationOrder.YXZ, 90, 0, 0, "-Z +Y +X")]
    [InlineData(RotationOrder.YXZ, 0, 90, 0, "+X +Z -Y")]
    [InlineData(RotationOrder.YXZ, 0, 0, 90, "+Y -X +Z")]
    [InlineData(RotationOrder.YXZ, 90, 90, 0, "-Z +X -Y")]
    [InlineData(RotationOrder.XYZ, 90, 0, 0, "+X +Z -Y")]
    [InlineData(RotationOrder.XYZ, 90, 90, 0, "+Y +Z +X")]
    [InlineData(RotationOrder.ZYX, 90, 90, 0, "-Z -X +Y")]
    [InlineData(RotationOrder.XZY, 0, 90, 0, "+Y -X +Z")]
    [InlineData(RotationOrder.YZX, 0, 0, 90, "+X +Z -Y")]
    [InlineData(RotationOrder.ZXY, -90, 0, 0, "-Y +X +Z")]
    [InlineData(RotationOrder.YXZ, 180, 0, 0, "-X +Y -Z")]
    public void Quarter_turns_follow_the_right_hand_rule(
        RotationOrder order, float first, float second, float third, string expected)
    {
        Quaternion rotation = EulerAngles.ToQuaternion(new Vector3(first, second, third), order);
        Vector3[] turned = [.. ((Vector3[])[Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ]).Select(axis => Vector3.Transform(axis, rotation))];
        Assert.Equal(expected, string.Join(' ', turned.Select(Axis)));
    }

    [Theory, MemberData(nameof(Orders))]
    public void A_rotation_is_the_product_of_three_in_the_order_of_the_name(RotationOrder order)
    {
        var random = new Random(1);
        for (int i = 0; i < 2000; i++)
        {
            Vector3 angles = RandomAngles(random, 720);
            Quaternion rotation = EulerAngles.ToQuaternion(angles, order);

            Assert.Equal(1, rotation.Length(), 1e-5f);
            AssertSame(ReferenceRotation.FromAngles(angles, order), rotation, angles);
        }
    }

    [Theory, MemberData(nameof(Orders))]
    public void Angles_reproduce_their_rotation(RotationOrder order)
    {
        var random = new Random(2);
        for (int i = 0; i < 2000; i++)
        {
            var rotation = new Quaternion(Signed(random), Signed(random), Signed(random), Signed(random));
            Vector3 angles = EulerAngles.FromQuaternion(rotation, order);

            AssertSame(ReferenceRotation.FromAngles(angles, order), rotation, angles);
            Assert.InRange(angles.X, -180, 180);
            Assert.InRange(angles.Y, -90, 90);
            Assert.InRange(angles.Z, -180, 180);
        }
    }

    [Theory, MemberData(nameof(Orders))]
    public void Angles_within_the_range_round_trip(RotationOrder order)
    {
        var random = new Random(3);
        for (int i = 0; i < 1000; i++)
        {
            Vector3 angles = new(179 * Signed(random), 85 * Signed(random), 179 * Signed(random));
            Vector3 back = EulerAngles.FromQuaternion(EulerAngles.ToQuaternion(angles, order), order);
            Assert.True(Vector3.Distance(angles, back) < 1e-3f, $"{angles} became {back}.");
        }
    }

    [Theory, MemberData(nameof(Orders))]
    public void Rotations_at_gimbal_lock_are_kept(RotationOrder order)
    {
        var random = new Random(4);
        float[] fromPole = [0, 1e-6f, 1e-5f, 1e-4f, 1e-3f, 1e-2f, 0.1f, 1];
        foreach (float distance in fromPole)
        {
            for (int i = 0; i < 100; i++)
            {
                Vector3 angles = RandomAngles(random, 180);
                angles.Y = (90 - distance) * (i % 2 == 0 ? 1 : -1);
                var expected = ReferenceRotation.FromAngles(angles, order);
                Vector3 back = EulerAngles.FromQuaternion(EulerAngles.ToQuaternion(angles, order), order);

                Assert.InRange(Math.Abs(back.Y), 88.9f, 90);
                double error = expected.Distance(ReferenceRotation.FromAngles(back, order));
                Assert.True(error < 5e-6, $"{angles} became {back}: off by {error}.");
            }
        }
    }

    [Theory, MemberData(nameof(Orders))]
    public void At_the_pole_the_third_angle_is_zero(RotationOrder order)
    {
        float half = MathF.Sqrt(0.5f);
        Quaternion quarter = order.ToString()[1] switch
        {
            'X' => new Quaternion(half, 0, 0, half),
            'Y' => new Quaternion(0, half, 0, half),
            _ => new Quaternion(0, 0, half, half),
        };
        Assert.Equal(new Vector3(0, 90, 0), EulerAngles.FromQuaternion(quarter, order));
        Assert.Equal(new Vector3(0, -90, 0), EulerAngles.FromQuaternion(Quaternion.Conjugate(quarter), order));
    }

    [Theory, MemberData(nameof(Orders))]
    public void Half_turns_are_kept(RotationOrder order)
    {
        foreach (Quaternion half in (Quaternion[])[new(1, 0, 0, 0), new(0, 1, 0, 0), new(0, 0, 1, 0), new(0, 0, -1, 0)])
            AssertSame(ReferenceRotation.FromAngles(EulerAngles.FromQuaternion(half, order), order), half, default);

        foreach (float sign in (float[])[-180, 180])
        {
            Vector3 angles = new(sign, 0, 0);
            AssertSame(ReferenceRotation.FromAngles(angles, order), EulerAngles.ToQuaternion(angles, order), angles);
        }
    }

    [Theory, MemberData(nameof(Orders))]
    public void Length_and_sign_of_the_quaternion_change_nothing(RotationOrder order)
    {
        Quaternion rotation = EulerAngles.ToQuaternion(new Vector3(30, -40, 50), order);
        Vector3 expected = EulerAngles.FromQuaternion(rotation, order);
        Assert.True(Vector3.Distance(expected, EulerAngles.FromQuaternion(rotation * 1000, order)) < 1e-4f);
        Assert.Equal(expected, EulerAngles.FromQuaternion(-rotation, order));
    }

    [Fact]
    public void The_same_rotation_by_angles_180_degrees_apart_is_the_same_quaternion_up_to_sign()
    {
        Quaternion one = EulerAngles.ToQuaternion(new Vector3(167.9936f, -179.7707f, 179.8350f), RotationOrder.YXZ);
        Quaternion other = EulerAngles.ToQuaternion(new Vector3(-12.0064f, -0.2293f, -0.1650f), RotationOrder.YXZ);
        Assert.Equal(1, Math.Abs(Quaternion.Dot(one, other)), 1e-6f);
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(6)] // the vendor's RO_Unknown
    public void An_order_that_does_not_exist_is_refused(int order)
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => EulerAngles.ToQuaternion(Vector3.Zero, (RotationOrder)order));
        Assert.Throws<ArgumentOutOfRangeException>(() => EulerAngles.FromQuaternion(Quaternion.Identity, (RotationOrder)order));
    }

    private static void AssertSame(ReferenceRotation expected, Quaternion rotation, Vector3 angles)
    {
        double error = expected.Distance(rotation);
        Assert.True(error < Tolerance, $"{angles}: off by {error}.");
    }

    private static string Axis(Vector3 vector)
    {
        float[] parts = [vector.X, vector.Y, vector.Z];
        int axis = Array.FindIndex(parts, part => Math.Abs(part) > 0.99999f);
        return axis < 0 ? "oblique" : (parts[axis] > 0 ? "+" : "-") + "XYZ"[axis];
    }

    private static Vector3 RandomAngles(Random random, float range) => new(range * Signed(random), range * Signed(random), range * Signed(random));

    private static float Signed(Random random) => (2 * random.NextSingle()) - 1;
}
