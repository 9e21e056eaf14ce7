using System.Numerics;
using NeuronMocap.Calculation;
using NeuronMocap.Tests.Calculation;

namespace NeuronMocap.Data.Tests.Calculation;

public sealed class CalculationAxesTests
{
    public static TheoryData<string> Takes => [.. CalculationText.Takes];

    [Theory, MemberData(nameof(Takes))]
    public void Recorded_gravity_points_along_z_for_every_sensor_rotation(string take)
    {
        CalculationDocument document = CalculationDocument.Load(Fixtures.Require("calc", take));
        Vector3 sum = Vector3.Zero;
        for (int i = 0; i < document.FrameCount; i++)
        {
            CalculationFrame frame = document.GetFrame(i);
            sum += CalculationAxes.Export.ToBvh(Vector3.Transform(frame.GetAcceleration(Bone.Hips), frame.GetSensorRotation(Bone.Hips)));
        }

        // One g downwards, plus the actor's own acceleration.
        Vector3 gravity = sum / document.FrameCount;
        Assert.InRange(gravity.Y, -1.2f, -0.9f);
        Assert.InRange(new Vector2(gravity.X, gravity.Z).Length(), 0, 0.05f);
    }

    [Theory]
    [InlineData("hiphop_up_Char00.calc")]
    [InlineData("salsa_left_Char00.calc")]
    public void Recorded_dancers_have_heads_above_feet_and_left_hands_on_the_left(string take)
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

    // Gyroscopes are independent of the quaternions. The two agree only if axes, handedness and the order of a quaternion are read correctly.
    [Theory, MemberData(nameof(Takes))]
    public void Recorded_sensors_turn_with_their_gyroscopes(string take)
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
                Vector3 gyroscope = CalculationAxes.Export.ToBvhAngularVelocity(document.GetFrame(i).GetAngularVelocity(bone));
                product += Vector3.Dot(velocity, gyroscope);
                turned += velocity.LengthSquared();
                measured += gyroscope.LengthSquared();
            }

            // Radians per second, at 120 Hz.
            Assert.InRange(product / measured, 0.8, 1.3);
            Assert.InRange(product / Math.Sqrt(turned * measured), 0.84, 1);
        }
    }

    private static Vector3 At(CalculationFrame frame, Bone bone) => CalculationAxes.Export.ToBvh(frame.GetPosition(bone));
}
