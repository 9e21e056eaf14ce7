using System.Numerics;
using NeuronMocap.Calculation;

namespace NeuronMocap.Tests.Calculation;

public sealed class CalculationAxesTests
{
    private static readonly Vector3 Left = Vector3.UnitX;
    private static readonly Vector3 Up = Vector3.UnitY;
    private static readonly Vector3 Forward = Vector3.UnitZ;

    public static TheoryData<BodyDirection, BodyDirection, BodyDirection> All
    {
        get
        {
            var all = new TheoryData<BodyDirection, BodyDirection, BodyDirection>();
            foreach (BodyDirection x in Enum.GetValues<BodyDirection>())
            {
                foreach (BodyDirection y in Enum.GetValues<BodyDirection>().Where(y => (int)y / 2 != (int)x / 2))
                {
                    foreach (BodyDirection z in Enum.GetValues<BodyDirection>().Where(z => (int)z / 2 == 3 - ((int)x / 2) - ((int)y / 2)))
                        all.Add(x, y, z);
                }
            }

            return all;
        }
    }

    [Fact]
    public void Exports_have_z_pointing_down()
    {
        Assert.Equal(-Up, CalculationAxes.Export.ToBvh(Vector3.UnitZ));
        Assert.Equal(Left, CalculationAxes.Export.ToBvh(Vector3.UnitX));
        Assert.Equal(Forward, CalculationAxes.Export.ToBvh(Vector3.UnitY));
        Assert.True(CalculationAxes.Export.IsRightHanded);
        Assert.Equal(new Vector3(1, 2, 3), CalculationAxes.Bvh.ToBvh(new Vector3(1, 2, 3)));
    }

    [Theory, MemberData(nameof(All))]
    public void Converting_axes_round_trips(BodyDirection x, BodyDirection y, BodyDirection z)
    {
        var axes = new CalculationAxes(x, y, z);
        var vector = new Vector3(1, -2, 3);
        var angular = new Vector3(0.1f, 0.2f, -0.3f);
        var rotation = Quaternion.Normalize(new Quaternion(0.1f, -0.7f, 0.3f, 0.5f));

        Assert.Equal(vector, axes.FromBvh(axes.ToBvh(vector)));
        Assert.Equal(rotation, axes.FromBvh(axes.ToBvh(rotation)));
        Assert.Equal(angular, axes.FromBvhAngularVelocity(axes.ToBvhAngularVelocity(angular)));
        Assert.Equal(Quaternion.Identity, axes.ToBvh(Quaternion.Identity));

        Vector3 expected = axes.ToBvh(RotateByHand(vector, rotation));
        Vector3 actual = Vector3.Transform(axes.ToBvh(vector), axes.ToBvh(rotation));
        Assert.InRange((expected - actual).Length(), 0, 1e-5f);
    }

    [Theory]
    [InlineData(BodyDirection.Left, BodyDirection.Right, BodyDirection.Up)]
    [InlineData(BodyDirection.Up, BodyDirection.Forward, BodyDirection.Up)]
    public void Collinear_axes_are_refused(BodyDirection x, BodyDirection y, BodyDirection z) =>
        Assert.Throws<ArgumentException>(() => new CalculationAxes(x, y, z));

    [Theory]
    [InlineData(338)]
    [InlineData(946)]
    public void Converting_a_row_round_trips(int columns)
    {
        float[] values = CalculationText.Values(3, columns);
        var axes = new CalculationAxes(BodyDirection.Forward, BodyDirection.Left, BodyDirection.Down);

        axes.ConvertToBvh(values);
        Assert.NotEqual(CalculationText.Values(3, columns), values);
        Assert.Equal(CalculationText.Values(3, columns)[336..338], values[336..338]);
        axes.ConvertFromBvh(values);

        Assert.Equal(CalculationText.Values(3, columns), values);
        Assert.Throws<ArgumentException>(() => axes.ConvertToBvh(new float[100]));
    }

    // The meaning of a quaternion's numbers, whatever the handedness of their axes.
    private static Vector3 RotateByHand(Vector3 vector, Quaternion rotation)
    {
        var axis = new Vector3(rotation.X, rotation.Y, rotation.Z);
        Vector3 twice = 2 * Vector3.Cross(axis, vector);
        return vector + (rotation.W * twice) + Vector3.Cross(axis, twice);
    }
}
