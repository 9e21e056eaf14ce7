using System.Numerics;
using NeuronMocap.Calculation;

namespace NeuronMocap.Tests.Calculation;

public sealed class CalculationAxesTests
{
    private static readonly Vector3 Left = Vector3.UnitX;
    private static readonly Vector3 Up = Vector3.UnitY;
    private static readonly Vector3 Forward = Vector3.UnitZ;

    public static TheoryData<string> Takes => [.. CalculationText.Takes];

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
    public void Exports_have_z_into_the_ground()
    {
        Assert.Equal(-Up, CalculationAxes.Export.ToBvh(Vector3.UnitZ));
        Assert.Equal(Left, CalculationAxes.Export.ToBvh(Vector3.UnitX));
        Assert.Equal(Forward, CalculationAxes.Export.ToBvh(Vector3.UnitY));
        Assert.True(CalculationAxes.Export.IsRightHanded);
        Assert.Equal(new Vector3(1, 2, 3), CalculationAxes.Bvh.ToBvh(new Vector3(1, 2, 3)));
    }

    [Theory, MemberData(nameof(All))]
    public void There_and_back_is_where_it_was_and_turns_turn_what_they_turned(BodyDirection x, BodyDirection y, BodyDirection z)
    {
        var axes = new CalculationAxes(x, y, z);
        var vector = new Vector3(1, -2, 3);
        var angular = new Vector3(0.1f, 0.2f, -0.3f);
        var rotation = Quaternion.Normalize(new Quaternion(0.1f, -0.7f, 0.3f, 0.5f));

        Assert.Equal(vector, axes.FromBvh(axes.ToBvh(vector)));
        Assert.Equal(rotation, axes.FromBvh(axes.ToBvh(rotation)));
        Assert.Equal(angular, axes.FromBvhAngular(axes.ToBvhAngular(angular)));
        Assert.Equal(Quaternion.Identity, axes.ToBvh(Quaternion.Identity));

        Vector3 expected = axes.ToBvh(RotateByHand(vector, rotation));
        Vector3 actual = Vector3.Transform(axes.ToBvh(vector), axes.ToBvh(rotation));
        Assert.InRange((expected - actual).Length(), 0, 1e-5f);
    }

    [Theory]
    [InlineData(BodyDirection.Left, BodyDirection.Right, BodyDirection.Up)]
    [InlineData(BodyDirection.Up, BodyDirection.Forward, BodyDirection.Up)]
    public void Axes_on_one_line_are_refused(BodyDirection x, BodyDirection y, BodyDirection z) =>
        Assert.Throws<ArgumentException>(() => new CalculationAxes(x, y, z));

    [Theory]
    [InlineData(338)]
    [InlineData(946)]
    public void A_row_there_and_back_is_the_same(int columns)
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

    [Theory, MemberData(nameof(Takes))]
    public void In_recordings_gravity_points_along_z_whatever_way_a_sensor_is_turned(string take)
    {
        CalculationDocument document = CalculationDocument.Load(Fixtures.Require("calc", take));
        Vector3 sum = Vector3.Zero;
        for (int i = 0; i < document.FrameCount; i++)
        {
            CalculationFrame frame = document.GetFrame(i);
            sum += CalculationAxes.Export.ToBvh(Vector3.Transform(frame.GetAcceleration(Bone.Hips), frame.GetSensorRotation(Bone.Hips)));
        }

        // One g downwards, save for what the actor's own motion adds.
        Vector3 gravity = sum / document.FrameCount;
        Assert.InRange(gravity.Y, -1.2f, -0.9f);
        Assert.InRange(new Vector2(gravity.X, gravity.Z).Length(), 0, 0.05f);
    }

    [Theory]
    [InlineData("hiphop_up_Char00.calc")]
    [InlineData("salsa_left_Char00.calc")]
    public void Dancers_of_the_recordings_have_heads_above_feet_and_left_hands_at_the_left(string take)
    {
        CalculationDocument document = CalculationDocument.Load(Fixtures.Require("calc", take));
        float hands = 0;
        for (int i = 0; i < document.FrameCount; i++)
        {
            CalculationFrame frame = document.GetFrame(i);
            Vector3 left = At(frame, Bone.LeftUpLeg) - At(frame, Bone.RightUpLeg);
            Assert.True(At(frame, Bone.Head).Y > At(frame, Bone.LeftFoot).Y + 1.2f);
            Assert.True(Vector3.Dot(left, At(frame, Bone.LeftShoulder) - At(frame, Bone.RightShoulder)) > 0);
            hands += Vector3.Dot(left, At(frame, Bone.LeftArm) - At(frame, Bone.RightArm));
        }

        Assert.True(hands > 0);
    }

    private static Vector3 At(CalculationFrame frame, Bone bone) => CalculationAxes.Export.ToBvh(frame.GetPosition(bone));

    // Gyroscopes know nothing of the quaternions: both agree only where axes, handedness and the order of a quaternion are read right.
    [Theory, MemberData(nameof(Takes))]
    public void In_recordings_sensors_turn_as_their_gyroscopes_say(string take)
    {
        CalculationDocument document = CalculationDocument.Load(Fixtures.Require("calc", take));
        foreach (Bone bone in (Bone[])[Bone.Hips, Bone.RightArm, Bone.LeftLeg])
        {
            double product = 0;
            double turned = 0;
            double measured = 0;
            for (int i = 1; i < document.FrameCount - 1; i++)
            {
                Quaternion before = CalculationAxes.Export.ToBvh(document.GetFrame(i - 1).GetSensorRotation(bone));
                Quaternion after = CalculationAxes.Export.ToBvh(document.GetFrame(i + 1).GetSensorRotation(bone));
                Quaternion turn = Quaternion.Conjugate(before) * after;
                turn = turn.W < 0 ? -turn : turn;
                Vector3 velocity = new Vector3(turn.X, turn.Y, turn.Z) * 2 * (float)(document.FrameRate / 2);
                Vector3 gyroscope = CalculationAxes.Export.ToBvhAngular(document.GetFrame(i).GetAngularVelocity(bone));
                product += Vector3.Dot(velocity, gyroscope);
                turned += velocity.LengthSquared();
                measured += gyroscope.LengthSquared();
            }

            // Radians per second, at 120 Hz.
            Assert.InRange(product / measured, 0.8, 1.3);
            Assert.InRange(product / Math.Sqrt(turned * measured), 0.84, 1);
        }
    }

    // What the numbers of a quaternion mean, whatever the handedness of the axes that they are given in.
    private static Vector3 RotateByHand(Vector3 vector, Quaternion rotation)
    {
        var axis = new Vector3(rotation.X, rotation.Y, rotation.Z);
        Vector3 twice = 2 * Vector3.Cross(axis, vector);
        return vector + (rotation.W * twice) + Vector3.Cross(axis, twice);
    }
}
