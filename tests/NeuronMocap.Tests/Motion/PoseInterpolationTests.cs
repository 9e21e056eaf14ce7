using System.Numerics;
using NeuronMocap.Motion;

namespace NeuronMocap.Tests.Motion;

public sealed class PoseInterpolationTests
{
    [Theory]
    [InlineData(0, 0)]
    [InlineData(0.25, 22.5)]
    [InlineData(1, 90)]
    [InlineData(1.5, 135)]
    [InlineData(-0.5, -45)]
    public void A_rotation_has_constant_speed_and_extrapolates(double part, double degrees)
    {
        foreach (float sign in (float[])[1, -1])
        {
            BoneTransform[] from = [Turned(0) with { Position = new Vector3(1, 2, 3) }];
            BoneTransform[] to = [new BoneTransform(new Vector3(3, 2, 1), Turned(90).Rotation * sign)];
            BoneTransform[] pose = new BoneTransform[1];
            PoseInterpolation.Linear(from, to, part, pose);

            Assert.True(SameTurn(Turned((float)degrees).Rotation, pose[0].Rotation), $"{pose[0].Rotation}");
            Assert.True(Vector3.Distance(Vector3.Lerp(from[0].Position, to[0].Position, (float)part), pose[0].Position) < 1e-5f);
        }
    }

    [Fact]
    public void The_smallest_rotations_are_kept()
    {
        foreach (float angle in (float[])[1e-5f, 1e-3f, 0.01f, 0.0115f, 0.02f, 1, 179])
        {
            BoneTransform[] pose = new BoneTransform[1];
            PoseInterpolation.Linear([Turned(0)], [Turned(angle)], 0.5, pose);
            float expected = MathF.Sin(angle / 2 * MathF.PI / 360);
            Assert.Equal(expected, pose[0].Rotation.Y, expected * 1e-5f);
        }
    }

    [Fact]
    public void A_cubic_is_exact_for_constant_acceleration_at_any_spacing()
    {
        (double First, double Second, double Third, double Fourth) times = (-0.013, 0.001, 0.009, 0.030);
        BoneTransform[] pose = new BoneTransform[1];
        for (double time = times.Second; time <= times.Third; time += 0.0005)
        {
            PoseInterpolation.Cubic(Four(times, Thrown), time, pose);
            Assert.True(Vector3.Distance(Thrown(time).Position, pose[0].Position) < 2e-5f, $"{time}: {pose[0].Position}");
            Assert.True(SameTurn(Thrown(time).Rotation, pose[0].Rotation, 1e-5f), $"{time}: {pose[0].Rotation}");
        }
    }

    [Fact]
    public void A_cubic_without_the_outer_frames_is_a_straight_line()
    {
        BoneTransform[] second = [Thrown(0)];
        BoneTransform[] third = [Thrown(0.01)];
        BoneTransform[] pose = new BoneTransform[1];
        PoseInterpolation.Cubic(new CubicPoseWindow { Second = second, Third = third, Times = (0, 0, 0.01, 0) }, 0.0025, pose);
        Assert.True(Vector3.Distance(Vector3.Lerp(second[0].Position, third[0].Position, 0.25f), pose[0].Position) < 1e-5f);
    }

    [Fact]
    public void A_cubic_rotates_evenly_between_distant_frames()
    {
        BoneTransform[] pose = new BoneTransform[1];
        PoseInterpolation.Cubic(Four((0, 1, 2, 3), static time => Turned((float)time * 90)), 1.25, pose);
        Assert.True(SameTurn(Turned(112.5f).Rotation, pose[0].Rotation), $"{pose[0].Rotation}");
    }

    [Fact]
    public void Quaternions_are_made_continuous()
    {
        var random = new Random(2);
        BoneTransform[] before = [.. Enumerable.Range(0, 59).Select(i => Turned(i))];
        for (int frame = 1; frame < 500; frame++)
        {
            BoneTransform[] raw = [.. Enumerable.Range(0, 59).Select(i => Turned((i + frame) * 3))];
            BoneTransform[] pose = [.. raw.Select(bone => bone with { Rotation = random.Next(2) == 0 ? bone.Rotation : Quaternion.Negate(bone.Rotation) })];
            if (frame == 1)
                pose.CopyTo(before, 0);
            PoseInterpolation.MakeContinuous(before, pose);
            for (int i = 0; i < 59; i++)
            {
                Assert.True(Quaternion.Dot(before[i].Rotation, pose[i].Rotation) > 0.99f || frame == 1);
                Assert.True(SameTurn(raw[i].Rotation, pose[i].Rotation));
            }

            before = pose;
        }
    }

    [Fact]
    public void Wrong_arguments_are_refused()
    {
        BoneTransform[] one = [Turned(0)];
        Assert.Throws<ArgumentException>(() => PoseInterpolation.Linear(one, [], 0, one));
        Assert.Throws<ArgumentException>(() => PoseInterpolation.Linear(one, one, 0, []));
        Assert.Throws<ArgumentException>(() => PoseInterpolation.MakeContinuous([], one));
        Assert.Throws<ArgumentException>(() => PoseInterpolation.Cubic(Four((0, 1, 1, 2), Thrown), 1, one));
    }

    private static CubicPoseWindow Four((double First, double Second, double Third, double Fourth) times, Func<double, BoneTransform> at) => new()
    {
        First = new[] { at(times.First) },
        Second = new[] { at(times.Second) },
        Third = new[] { at(times.Third) },
        Fourth = new[] { at(times.Fourth) },
        Times = times,
    };

    private static BoneTransform Thrown(double time) => new(
        new Vector3((float)(50 * time), (float)((200 * time) - (490.5 * time * time)), 10),
        Turned((float)(100 * time)).Rotation);

    private static BoneTransform Turned(float degrees) =>
        new(Vector3.Zero, Quaternion.CreateFromAxisAngle(Vector3.UnitY, degrees * MathF.PI / 180));

    private static bool SameTurn(Quaternion one, Quaternion other, float tolerance = 1e-5f) =>
        ((one * Math.Sign(Quaternion.Dot(one, other))) - other).Length() < tolerance;
}
