using System.Globalization;
using System.Numerics;
using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Server.Sources;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Server.Sources;

namespace NeuronMocap.Server.Tests.Sources;

// The effect of a zero-out on a performance.
public sealed class ZeroOutSourceTests
{
    private const long Now = 100;

    public static MatrixTheoryData<string, RotationOrder, bool, bool> EveryFormat =>
        new(["actor", "take", "take with reference"], Enum.GetValues<RotationOrder>(), [false, true], [false, true]);

    [Theory, MemberData(nameof(EveryFormat))]
    public void A_zero_out_turns_the_hips_in_place(string kind, RotationOrder order, bool displacement, bool reference)
    {
        MotionSource raw = CreateSource(kind);
        var turnable = new ZeroOutSource(raw);
        var layout = new ChannelLayout(displacement, reference);
        Span<float> before = new float[layout.ValueCount];
        Span<float> after = new float[layout.ValueCount];
        raw.WriteValues(Now, layout, order, before);
        turnable.WriteValues(Now - 1, layout, order, after);
        turnable.FaceFront(long.MaxValue);
        turnable.WriteValues(Now, layout, order, after);

        BoneTransform was = Hips(before, layout, order);
        BoneTransform hips = Hips(after, layout, order);
        Assert.True(Vector3.Distance(was.Position, hips.Position) < 1e-2, $"{was.Position} {hips.Position}");
        Assert.Equal(0, Heading(hips), 0.1);
        Assert.NotEqual(0, Heading(was), 5.0);

        // The vertical direction stays: the body keeps its lean.
        Assert.Equal(Vector3.Transform(Vector3.UnitZ, was.Rotation).Y, Vector3.Transform(Vector3.UnitZ, hips.Rotation).Y, 1e-3);
        before.Slice(layout.GetPositionIndex(Bone.Hips), 6).CopyTo(after[layout.GetPositionIndex(Bone.Hips)..]);
        Assert.Equal(before.ToArray(), after.ToArray());
    }

    [Fact]
    public void The_path_continues_turned_about_the_zero_out()
    {
        MotionSource raw = CreateSource("actor");
        var turnable = new ZeroOutSource(raw);
        BoneTransform start = PoseOf(turnable, Now - 1)[0];
        turnable.FaceFront(long.MaxValue);
        BoneTransform pivot = PoseOf(raw, Now)[0];
        Quaternion turn = PoseOf(turnable, Now)[0].Rotation * Quaternion.Conjugate(pivot.Rotation);

        for (long frame = Now; frame < Now + 500; frame += 50)
        {
            BoneTransform expected = PoseOf(raw, frame)[0];
            BoneTransform actual = PoseOf(turnable, frame)[0];
            Vector3 moved = Vector3.Transform(expected.Position - pivot.Position, turn) + pivot.Position;
            Assert.True(Vector3.Distance(moved, actual.Position) < 1e-2);
            Assert.Equal(1, Math.Abs(Quaternion.Dot(turn * expected.Rotation, actual.Rotation)), 1e-4);
        }

        Assert.Equal(start, PoseOf(turnable, Now - 1)[0]);
    }

    [Fact]
    public void A_zero_out_never_changes_earlier_frames()
    {
        var turnable = new ZeroOutSource(CreateSource("actor"));
        var asked = new List<(long Frame, BoneTransform Hips)>();
        for (long frame = 0; frame < 900; frame++)
        {
            asked.Add((frame, PoseOf(turnable, frame)[0]));
            if (frame % 300 == 299)
                turnable.FaceFront(long.MaxValue);
            if (frame is 300 or 600)
                Assert.Equal(0, Heading(asked[^1].Hips), 0.1);
            if (frame is 300 or 600)
                Assert.True(Vector3.Distance(asked[^1].Hips.Position, asked[^2].Hips.Position) < 5);
        }

        foreach ((long frame, BoneTransform hips) in asked)
            Assert.Equal(hips, PoseOf(turnable, frame)[0]);
    }

    [Fact]
    public void A_second_zero_out_in_the_same_frame_changes_nothing()
    {
        var turnable = new ZeroOutSource(CreateSource("take"));
        turnable.FaceFront(long.MaxValue);
        turnable.FaceFront(long.MaxValue);
        BoneTransform hips = PoseOf(turnable, 0)[0];
        Assert.Equal(0, Heading(hips), 0.1);
        Assert.True(Vector3.Distance(PoseOf(CreateSource("take"), 0)[0].Position, hips.Position) < 1e-2);
    }

    [Fact]
    public void A_zero_out_after_the_last_frame_is_ignored()
    {
        var source = new BvhSource(BvhDocument.Parse(NeuronTake.Write(rows: 3)));
        var turnable = new ZeroOutSource(source);
        PoseOf(turnable, 2);
        turnable.FaceFront(long.MaxValue);
        Assert.Equal(PoseOf(source, 2)[0], PoseOf(turnable, 2)[0]);
    }

    [Fact]
    public void A_lying_actor_is_turned_about_the_vertical()
    {
        // The actor lies on the back, so forward is up.
        byte[] file = NeuronTake.Write(2, static (_, bone) => bone == Bone.Hips ? new Vector3(40, -90, 0) : Vector3.Zero);
        var turnable = new ZeroOutSource(new BvhSource(BvhDocument.Parse(file)));
        turnable.FaceFront(long.MaxValue);
        Quaternion expected = EulerAngles.ToQuaternion(new Vector3(0, -90, 0), RotationOrder.YXZ);
        Assert.Equal(1, Math.Abs(Quaternion.Dot(expected, PoseOf(turnable, 0)[0].Rotation)), 1e-4);
    }

    [Fact]
    public void Calculation_data_follow_without_sensing_the_turn()
    {
        MotionSource raw = CreateSource("actor");
        var turnable = new ZeroOutSource(raw);
        PoseOf(turnable, Now - 1);
        turnable.FaceFront(long.MaxValue);
        float[] expected = new float[CalculationFrame.FullValueCount];
        float[] actual = new float[CalculationFrame.FullValueCount];
        for (long frame = Now - 2; frame < Now + 3; frame++)
        {
            CalculationSynthesizer.Write(raw, frame, expected);
            CalculationSynthesizer.Write(turnable.At(frame), frame, actual);
            for (int bone = 0; bone < 21; bone++)
            {
                ReadOnlySpan<float> was = expected.AsSpan(bone * 16, 16);
                ReadOnlySpan<float> now = actual.AsSpan(bone * 16, 16);
                Assert.Equal(new Vector3(was[3], was[4], was[5]).Length(), new Vector3(now[3], now[4], now[5]).Length(), 2e-2);
                for (int value = 10; value < 16; value++)
                    Assert.Equal(was[value], now[value], 0.1);
            }
        }

        Assert.Equal(0, Heading(new BoneTransform(default, new Quaternion(actual[7], actual[8], actual[9], actual[6]))), 20.0);
    }

    // A server runs for days, and every client can send a request with every frame.
    [Fact]
    public void Many_zero_outs_take_constant_memory()
    {
        var turnable = new ZeroOutSource(CreateSource("actor"));
        for (long frame = 0; frame < 6 * ZeroOutSource.MaxTurns; frame++)
        {
            PoseOf(turnable, frame);
            Assert.True(turnable.FaceFront(long.MaxValue));
        }

        Assert.Equal(ZeroOutSource.MaxTurns, turnable.TurnCount);
        Assert.Equal(0, Heading(PoseOf(turnable, 6 * ZeroOutSource.MaxTurns)[0]), 0.1);
    }

    [Theory]
    [InlineData(float.NaN, 0)]
    [InlineData(0, float.NaN)]
    [InlineData(float.PositiveInfinity, 0)]
    [InlineData(float.MaxValue, 0)]
    public void A_pose_that_is_not_finite_does_not_affect_later_poses(float position, float rotation)
    {
        var turnable = new ZeroOutSource(new BrokenPose(badFrame: 1, position, rotation));
        PoseOf(turnable, 0);
        Assert.False(turnable.FaceFront(long.MaxValue));
        PoseOf(turnable, 1);
        Assert.True(turnable.FaceFront(long.MaxValue));

        BoneTransform hips = PoseOf(turnable, 2)[0];
        Assert.Equal(0, Heading(hips), 0.1);
        Assert.Equal(new Vector3(1, 2, 3), hips.Position);
    }

    internal static double Heading(BoneTransform hips)
    {
        Vector3 forward = Vector3.Transform(Vector3.UnitZ, hips.Rotation);
        return Math.Atan2(forward.X, forward.Z) * 180 / Math.PI;
    }

    private static BoneTransform Hips(ReadOnlySpan<float> values, ChannelLayout layout, RotationOrder order)
    {
        BoneTransform hips = Read(values[layout.GetPositionIndex(Bone.Hips)..], order);
        return layout.HasReference ? Read(values, order).Apply(hips) : hips;
    }

    private static BoneTransform Read(ReadOnlySpan<float> values, RotationOrder order) => new(
        new Vector3(values[0], values[1], values[2]), EulerAngles.ToQuaternion(new Vector3(values[3], values[4], values[5]), order));

    // An actor who stands in one place and looks to the side, except in one frame.
    private sealed class BrokenPose(long badFrame, float position, float rotation) : MotionSource
    {
        public override double FrameRate => 60;

        public override long? FrameCount => null;

        public override bool HasDisplacement => true;

        public override void GetPose(long frame, Span<BoneTransform> pose)
        {
            pose.Fill(BoneTransform.Identity);
            pose[0] = frame == badFrame
                ? new BoneTransform(new Vector3(position, 0, 0), new Quaternion(rotation, 0, 0, 1))
                : new BoneTransform(new Vector3(1, 2, 3), Quaternion.CreateFromAxisAngle(Vector3.UnitY, 1));
        }

        public override FootContacts GetFootContacts(long frame) => default;
    }

    private static BoneTransform[] PoseOf(MotionSource source, long frame)
    {
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        source.GetPose(frame, pose);
        return pose;
    }

    private static MotionSource CreateSource(string kind) => kind switch
    {
        "actor" => new SyntheticSource(60, avatarIndex: 1),
        "take" => new LoopedSource(new BvhSource(BvhDocument.Parse(NeuronTake.Write(rows: 7, static (row, bone) =>
            new Vector3(100 + (row * 7), 10 + ((int)bone % 40), row - (int)bone))))),
        _ => new LoopedSource(new BvhSource(BvhDocument.Parse(WithReference()))),
    };

    private static byte[] WithReference()
    {
        var layout = new ChannelLayout(hasDisplacement: true, hasReference: true);
        string row = string.Join(' ', Enumerable.Range(0, layout.ValueCount).Select(static i => ((i * 17 % 60) - 25).ToString(CultureInfo.InvariantCulture)));
        return Encoding.ASCII.GetBytes(
            BvhHierarchyText.Create(SkeletonFormat.Default, layout) + $"MOTION\nFrames: 1\nFrame Time: 0.01\n{row}\n");
    }
}
