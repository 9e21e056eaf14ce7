using System.Numerics;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Server.Sources;

namespace NeuronMocap.Server.Tests.Sources;

public class CalculationSynthesizerTests
{
    private const double Rate = 60;

    [Fact]
    public void Positions_are_bone_centres_in_metres_and_rotations_are_the_bones()
    {
        var actor = new SyntheticSource(Rate, 1);
        for (long frame = 0; frame < 2400; frame += 111)
        {
            CalculationFrame calculation = Calculate(actor, frame);
            BoneTransform[] world = ActorMeasures.GetWorld(actor, frame);
            foreach (Bone bone in BoneHierarchy.Bones)
                Assert.True(ActorMeasures.Degrees(world[(int)bone].Rotation, calculation.GetSensorRotation(bone)) < 1e-3);

            AssertNear(world[(int)Bone.Hips].Position / 100, calculation.GetPosition(Bone.Hips));
            AssertNear(Middle(world, Bone.RightUpLeg, Bone.RightLeg), calculation.GetPosition(Bone.RightUpLeg));
            AssertNear(Middle(world, Bone.Spine2, Bone.Neck), calculation.GetPosition(Bone.Spine2));
            AssertNear(Middle(world, Bone.LeftForeArm, Bone.LeftHand), calculation.GetPosition(Bone.LeftForeArm));
            AssertNear(Middle(world, Bone.RightHand, Bone.RightInHandMiddle), calculation.GetPosition(Bone.RightHand));
            AssertNear(Middle(world, Bone.LeftHand, Bone.LeftInHandMiddle), calculation.GetPosition(Bone.LeftHand));
            AssertNear(Middle(world, Bone.LeftHandRing1, Bone.LeftHandRing2), calculation.GetPosition(Bone.LeftHandRing1));
            AssertNear(world[(int)Bone.Head].TransformPoint(new Vector3(0, 8.5f, 0)) / 100, calculation.GetPosition(Bone.Head));
            AssertNear(
                world[(int)Bone.RightFoot].TransformPoint(new Vector3(0, -5, 7.875f)) / 100, calculation.GetPosition(Bone.RightFoot));
            AssertNear(
                world[(int)Bone.LeftHandPinky3].TransformPoint(new Vector3(0.799f, 0, 0)) / 100,
                calculation.GetPosition(Bone.LeftHandPinky3));
        }
    }

    [Fact]
    public void Velocities_sum_up_to_the_path()
    {
        var actor = new SyntheticSource(Rate);
        CalculationFrame[] frames = [.. Enumerable.Range(0, 301).Select(frame => Calculate(actor, frame))];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            // Trapezoids between central differences. The omitted ends amount to less than a few millimetres.
            Vector3 way = Vector3.Zero;
            for (int i = 1; i < frames.Length; i++)
                way += (frames[i - 1].GetVelocity(bone) + frames[i].GetVelocity(bone)) / (2 * (float)Rate);

            AssertNear(frames[^1].GetPosition(bone) - frames[0].GetPosition(bone), way, 0.005f);
        }
    }

    [Fact]
    public void A_resting_body_measures_one_g_down_in_bone_axes()
    {
        Quaternion bowed = Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2);
        FormulaSource bowing = Move((_, pose) => pose[(int)Bone.Neck] = pose[(int)Bone.Neck] with { Rotation = bowed });
        CalculationFrame calculation = Calculate(bowing, 9);

        foreach (Bone bone in BoneHierarchy.Bones)
        {
            bool bows = bone is Bone.Neck or Bone.Neck1 or Bone.Head;
            AssertNear(bows ? Vector3.UnitZ : -Vector3.UnitY, calculation.GetAcceleration(bone));
            AssertNear(Vector3.Zero, calculation.GetVelocity(bone));
            AssertNear(Vector3.Zero, calculation.GetAngularVelocity(bone));
        }
    }

    [Fact]
    public void A_falling_body_measures_no_acceleration()
    {
        FormulaSource falling = Move((frame, pose) => Shift(pose, new Vector3(0, -980.665f / 2 * Square(frame / Rate), 0)));
        FormulaSource starting = Move((frame, pose) => Shift(pose, new Vector3(0, 0, 980.665f / 2 * Square(frame / Rate))));
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            AssertNear(Vector3.Zero, Calculate(falling, 20).GetAcceleration(bone), 0.01f);
            AssertNear(new Vector3(0, -9.80665f * 20 / 60, 0), Calculate(falling, 20).GetVelocity(bone), 0.01f);
            AssertNear(new Vector3(0, -1, -1), Calculate(starting, 20).GetAcceleration(bone), 0.01f);
        }
    }

    [Fact]
    public void A_turning_body_measures_radians_per_second_in_bone_axes()
    {
        Quaternion bowed = Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2);
        FormulaSource turning = Move((frame, pose) =>
        {
            // A quaternion and its negative are the same rotation. A source may switch between them at any time.
            Quaternion turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, (float)(frame / Rate * 3));
            pose[0] = pose[0] with { Rotation = frame % 4 < 2 ? turn : -turn };
            pose[(int)Bone.Neck] = pose[(int)Bone.Neck] with { Rotation = bowed };
        });

        // At 3 radians a second, frames 0 to 300 pass through more than a full turn.
        foreach (long frame in (long[])[0, 1, 62, 63, 126, 299])
        {
            CalculationFrame calculation = Calculate(turning, frame);
            AssertNear(new Vector3(0, 3, 0), calculation.GetAngularVelocity(Bone.Hips));
            AssertNear(new Vector3(0, 3, 0), calculation.GetAngularVelocity(Bone.LeftHandPinky3));
            AssertNear(new Vector3(0, 0, -3), calculation.GetAngularVelocity(Bone.Head));
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(5)]
    public void The_ends_of_a_take_use_existing_frames(long count)
    {
        FormulaSource source = Move((frame, pose) => Shift(pose, new Vector3(frame * frame, 0, 0)), count);
        for (long frame = 0; frame < count; frame++)
        {
            CalculationFrame calculation = Calculate(source, frame);
            long before = Math.Max(0, frame - 1);
            long after = Math.Min(count - 1, frame + 1);
            float velocity = after == before ? 0 : (float)(Rate * ((after * after) - (before * before)) / (after - before) / 100);
            float acceleration = count < 3 ? 0 : (float)(Rate * Rate * 2 / 100 / 9.80665);
            AssertNear(new Vector3(frame * frame / 100f, 0.84102f, 0), calculation.GetPosition(Bone.Hips));
            AssertNear(new Vector3(velocity, 0, 0), calculation.GetVelocity(Bone.Hips));
            AssertNear(new Vector3(-acceleration, -1, 0), calculation.GetAcceleration(Bone.Hips), 1e-3f);
        }
    }

    [Fact]
    public void Contacts_come_from_the_source()
    {
        FormulaSource source = Move((_, _) => { });
        for (long frame = 0; frame < 6; frame++)
        {
            CalculationFrame calculation = Calculate(source, frame);
            Assert.Equal(source.GetFootContacts(frame), calculation.FootContacts);
        }

        Assert.Equal([1, 0], Calculate(source, 2).Values.Slice(336, 2).ToArray());
    }

    [Fact]
    public void The_short_form_is_a_prefix_of_the_long_form()
    {
        var actor = new SyntheticSource(Rate);
        float[] full = new float[946];
        float[] body = new float[338];
        full.AsSpan().Fill(float.NaN);
        body.AsSpan().Fill(float.NaN);
        CalculationSynthesizer.Write(actor, 500, full);
        CalculationSynthesizer.Write(actor, 500, body);

        Assert.DoesNotContain(float.NaN, full);
        Assert.Equal(full[..338], body);
    }

    [Fact]
    public void A_frame_allocates_nothing()
    {
        var actor = new SyntheticSource(Rate);
        float[] values = new float[946];
        void Play()
        {
            for (long frame = 0; frame < 50; frame++)
                CalculationSynthesizer.Write(actor, frame * 47, values);
        }

        Play();
        Assert.Equal(0, Allocations.Least(() => Allocations.OnThisThread(Play)));
    }

    [Fact]
    public void Invalid_frames_and_lengths_are_refused()
    {
        FormulaSource source = Move((_, _) => { }, count: 10);
        Assert.Throws<ArgumentException>(() => CalculationSynthesizer.Write(source, 0, new float[944]));
        Assert.Throws<ArgumentOutOfRangeException>(() => CalculationSynthesizer.Write(source, -1, new float[946]));
        Assert.Throws<ArgumentOutOfRangeException>(() => CalculationSynthesizer.Write(source, 10, new float[946]));
    }

    private static CalculationFrame Calculate(MotionSource source, long frame)
    {
        float[] values = new float[CalculationFrame.FullValueCount];
        CalculationSynthesizer.Write(source, frame, values);
        return new CalculationFrame(new CalculationHeader(), values);
    }

    private static FormulaSource Move(FormulaSource.Formula formula, long? count = null) => new(Rate, count, formula);

    private static void Shift(Span<BoneTransform> pose, Vector3 way) => pose[0] = pose[0] with { Position = pose[0].Position + way };

    private static float Square(double value) => (float)(value * value);

    private static Vector3 Middle(BoneTransform[] world, Bone bone, Bone child) =>
        (world[(int)bone].Position + world[(int)child].Position) / 200;

    private static void AssertNear(Vector3 expected, Vector3 actual, float tolerance = 1e-4f) =>
        Assert.True((expected - actual).Length() < tolerance, $"{expected} expected, {actual} found");
}
