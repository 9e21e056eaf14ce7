using Random = System.Random;

namespace NeuronMocap.Unity.Tests.StandIn;

/// <summary>The rules of Unity's left-handed rotations, as its reference states them, on known numbers.</summary>
public sealed class QuaternionTests
{
    [Theory]
    [InlineData(90, 0, 0, 0, 0, 1, 0, -1, 0)]
    [InlineData(0, 90, 0, 0, 0, 1, 1, 0, 0)]
    [InlineData(0, 0, 90, 1, 0, 0, 0, 1, 0)]
    [InlineData(90, 90, 0, 0, 1, 0, 1, 0, 0)]
    public void Positive_angles_turn_clockwise_seen_along_the_axis(float x, float y, float z, float fromX, float fromY, float fromZ, float toX, float toY, float toZ) =>
        Near(new Vector3(toX, toY, toZ), Quaternion.Euler(x, y, z) * new Vector3(fromX, fromY, fromZ));

    [Fact]
    public void Euler_angles_turn_about_z_then_x_then_y()
    {
        Quaternion expected = Quaternion.AngleAxis(20, Vector3.up) * Quaternion.AngleAxis(10, Vector3.right) * Quaternion.AngleAxis(30, Vector3.forward);

        Assert.InRange(Quaternion.Angle(expected, Quaternion.Euler(10, 20, 30)), 0, 0.01f);
        Near(new Vector3(10, 20, 30), Quaternion.Euler(10, 20, 30).eulerAngles, 1e-3f);
        Assert.Equal(0.1276794f, Quaternion.Euler(10, 20, 30).x, 5);
        Assert.Equal(0.1448781f, Quaternion.Euler(10, 20, 30).y, 5);
        Assert.Equal(0.2392984f, Quaternion.Euler(10, 20, 30).z, 5);
        Assert.Equal(0.9515485f, Quaternion.Euler(10, 20, 30).w, 5);
    }

    [Fact]
    public void Products_apply_the_right_factor_first()
    {
        var random = new Random(4);
        for (int i = 0; i < 200; i++)
        {
            Quaternion a = Turn(random);
            Quaternion b = Turn(random);
            Vector3 point = Point(random);

            Near(a * (b * point), a * b * point);
            Near(point, Quaternion.Inverse(a) * (a * point));
            Near(Matrix4x4.Rotate(a).MultiplyVector(point), a * point);
            Assert.InRange(Quaternion.Angle(a, Quaternion.Euler(a.eulerAngles)), 0, 0.1f);
            Assert.InRange(Quaternion.Angle(a, Matrix4x4.TRS(point, a, new Vector3(2, 3, 4)).rotation), 0, 0.1f);
        }
    }

    [Fact]
    public void LookRotation_points_z_along_the_view()
    {
        var random = new Random(5);
        for (int i = 0; i < 200; i++)
        {
            Vector3 view = Point(random);
            Vector3 up = Point(random);
            Quaternion look = Quaternion.LookRotation(view, up);

            Near(view.normalized, look * Vector3.forward);
            Assert.Equal(0, Vector3.Dot(look * Vector3.right, up.normalized), 3);
            Assert.True(Vector3.Dot(look * Vector3.up, up) > 0);
            Near(look * Vector3.right, Vector3.Cross(look * Vector3.up, look * Vector3.forward));
            Near(up.normalized, Quaternion.FromToRotation(view, up) * view.normalized);
        }

        Near(Vector3.down, Quaternion.LookRotation(Vector3.down) * Vector3.forward);
        Near(Vector3.down, Quaternion.FromToRotation(Vector3.up, Vector3.down) * Vector3.up);
    }

    [Fact]
    public void Slerp_takes_the_short_path_at_constant_speed()
    {
        var from = Quaternion.AngleAxis(10, Vector3.up);
        var to = Quaternion.AngleAxis(130, Vector3.up);
        var negated = new Quaternion(-to.x, -to.y, -to.z, -to.w);

        Assert.InRange(Quaternion.Angle(Quaternion.AngleAxis(40, Vector3.up), Quaternion.Slerp(from, to, 0.25f)), 0, 0.01f);
        Assert.InRange(Quaternion.Angle(Quaternion.AngleAxis(40, Vector3.up), Quaternion.Slerp(from, negated, 0.25f)), 0, 0.01f);
        Assert.Equal(120, Quaternion.Angle(from, to), 2);
        Assert.InRange(Quaternion.Angle(Quaternion.AngleAxis(15, Vector3.up), Quaternion.RotateTowards(from, to, 5)), 0, 0.01f);
        to.ToAngleAxis(out float angle, out Vector3 axis);
        Assert.Equal(130, angle, 3);
        Near(Vector3.up, axis);
        Assert.True(to == negated == false);
    }

    internal static Quaternion Turn(Random random) =>
        Quaternion.Normalize(new Quaternion(Value(random), Value(random), Value(random), Value(random)));

    internal static Vector3 Point(Random random) => new Vector3(Value(random), Value(random), Value(random)) + (Vector3.one * 1e-3f);

    internal static void Near(Vector3 expected, Vector3 actual, float within = 1e-4f) =>
        Assert.True((expected - actual).magnitude <= within, $"{actual.ToString("F5")} instead of {expected.ToString("F5")}");

    private static float Value(Random random) => (float)((random.NextDouble() * 2) - 1);
}
