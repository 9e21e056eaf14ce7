using System.Numerics;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.View.Takes;

namespace NeuronMocap.Tool.Tests.View.Takes;

public sealed class TakeCurveTests
{
    [Fact]
    public async Task A_curve_of_single_frames_has_their_times_and_values()
    {
        using var takes = new OpenTakes();
        TakePerformer performer = await WalkAsync(takes, frames: 121);

        TakeCurve height = TakeCurve.Of(performer, Bone.Hips, CurveQuantity.Height, 0, 2_000_000, 1000);
        TakeCurve speed = TakeCurve.Of(performer, Bone.Head, CurveQuantity.Speed, 0, 2_000_000, 1000);

        Assert.Equal(121, height.Times.Length);
        Assert.Equal(1000, height.Times[60], 1);
        Assert.All(height.Lowest, value => Assert.Equal(height.Lowest[0], value, 4));
        Assert.All(speed.Highest, static value => Assert.Equal(1, value, 2));
    }

    [Fact]
    public async Task A_reduced_curve_keeps_every_peak()
    {
        using var takes = new OpenTakes();
        Files.Takes.Neuron(1500, static (frame, pose) =>
        {
            if (frame == 1234)
                Files.Takes.Move(pose, new Vector3(0, 50, 0));
        }).Save(takes.Folder["jump.bvh"]);
        TakePerformer performer = (await takes.OpenAsync(takes.Folder["jump.bvh"])).Performers[0];
        long end = performer.Times.End;

        TakeCurve coarse = TakeCurve.Of(performer, Bone.Head, CurveQuantity.Height, 0, end, 10);
        TakeCurve fine = TakeCurve.Of(performer, Bone.Head, CurveQuantity.Height, 0, end, 500);

        Assert.Equal(10, coarse.Times.Length);
        Assert.Equal(500, fine.Times.Length);
        Assert.Equal(coarse.Highest.Max(), fine.Highest.Max(), 5);
        Assert.Equal(0.5f, coarse.Highest.Max() - coarse.Lowest.Min(), 4);
        Assert.Equal(1234 / 60.0, coarse.Times[Array.IndexOf(coarse.Highest, coarse.Highest.Max())] / 1000, tolerance: 1.5);
    }

    [Fact]
    public async Task The_angle_is_that_from_the_rest_pose()
    {
        using var takes = new OpenTakes();
        Files.Takes.Neuron(3, static (_, pose) => pose[(int)Bone.RightLeg] = pose[(int)Bone.RightLeg] with
        {
            Rotation = Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 3),
        }).Save(takes.Folder["knee.bvh"]);
        TakePerformer performer = (await takes.OpenAsync(takes.Folder["knee.bvh"])).Performers[0];

        TakeCurve curve = TakeCurve.Of(performer, Bone.RightLeg, CurveQuantity.Angle, 0, 1_000_000, 10);

        Assert.All(curve.Highest, static value => Assert.Equal(60, value, 1));
    }

    [Fact]
    public async Task A_gap_has_no_speed_and_no_values()
    {
        using var takes = new OpenTakes();
        string path = takes.Record(Enumerable.Range(0, 600).Select(static i => (i * 10.0 + (i < 300 ? 0 : 60_000), 0, i)));
        TakePerformer performer = (await takes.OpenAsync(path)).Performers[0];

        TakeCurve curve = TakeCurve.Of(performer, Bone.Hips, CurveQuantity.Speed, 0, performer.Times.End, 9);

        Assert.True(curve.Highest.Where(static value => float.IsFinite(value)).Max() < 10);
        Assert.DoesNotContain(curve.Times.Zip(curve.Highest), static point => point.First is > 10_000 and < 55_000 && float.IsFinite(point.Second));
    }

    [Fact]
    public void Long_takes_have_contacts_without_seams()
    {
        var finder = new ContactFinder();
        SkeletonBody body = SkeletonBody.GetDefault();
        BoneTransform[] world = new BoneTransform[BoneHierarchy.BoneCount];
        body.CopyRestPose(world);
        ForwardKinematics.ToWorld(world, world);
        for (int frame = 0; frame < 40_000; frame++)
            finder.Add(world, body, frame * 16_667L, isAfterGap: false, measured: null);

        finder.Finish();

        // The actor stands still for eleven minutes: one contact of each foot.
        (var left, var right) = finder.GetContacts();
        Assert.Equal(new TimeStretch(0, 39_999 * 16_667L), Assert.Single(left));
        Assert.Equal(new TimeStretch(0, 39_999 * 16_667L), Assert.Single(right));
    }

    private static async Task<TakePerformer> WalkAsync(OpenTakes takes, int frames)
    {
        Files.Takes.Neuron(frames, (frame, pose) => Files.Takes.Move(pose, new Vector3(0, 0, frame * 100 / 60f))).Save(takes.Folder["walk.bvh"]);
        return (await takes.OpenAsync(takes.Folder["walk.bvh"])).Performers[0];
    }
}
