using System.Numerics;
using NeuronMocap.Tests.Server.Sources;

namespace NeuronMocap.Server.Tests.Sources;

public class SyntheticActorGaitTests
{
    private const float Millimetre = 0.1f;

    public static TheoryData<double, int, long> Performances => new()
    {
        { 60, 0, 0 },
        { 120, 0, 0 },
        { 60, 1, 0 },
        { 95.9, 2, 7 },
        { 60, 3, 1_000_000_000 },
        { 59.94, 0, 1_000_000_000_000 },
    };

    [Theory]
    [MemberData(nameof(Performances))]
    public void A_planted_foot_does_not_move(double rate, int avatar, long start)
    {
        var actor = new SyntheticSource(rate, avatar);
        var planted = new Vector3[]?[2];
        int stances = 0;
        foreach (long frame in Minute(rate, start))
        {
            BoneTransform[] world = ActorMeasures.GetWorld(actor, frame);
            for (int side = 0; side < 2; side++)
            {
                BoneTransform foot = world[(int)Foot(side)];
                Vector3[] points = [foot.Position, .. ActorMeasures.GetSole(foot)];
                if (!IsPlanted(actor, frame, side))
                {
                    planted[side] = null;
                }
                else if (planted[side] is not { } first)
                {
                    planted[side] = points;
                    stances++;
                }
                else
                {
                    for (int i = 0; i < points.Length; i++)
                        Assert.True((points[i] - first[i]).Length() < Millimetre, $"frame {frame}, {Foot(side)}");
                }
            }
        }

        Assert.InRange(stances, 40, 70);
    }

    [Theory]
    [MemberData(nameof(Performances))]
    public void No_foot_goes_below_the_ground_and_a_planted_one_is_on_it(double rate, int avatar, long start)
    {
        var actor = new SyntheticSource(rate, avatar);
        foreach (long frame in Minute(rate, start))
        {
            BoneTransform[] world = ActorMeasures.GetWorld(actor, frame);
            for (int side = 0; side < 2; side++)
            {
                foreach (Vector3 point in ActorMeasures.GetSole(world[(int)Foot(side)]))
                    Assert.InRange(point.Y, -Millimetre, IsPlanted(actor, frame, side) ? Millimetre : 60);
            }
        }
    }

    [Fact]
    public void One_foot_is_always_planted_and_every_step_clears_the_ground()
    {
        var actor = new SyntheticSource(120);
        float[] height = [-1, -1];
        int steps = 0;
        for (long frame = 0; frame < 120 * ActorMeasures.LapSeconds; frame++)
        {
            BoneTransform[] world = ActorMeasures.GetWorld(actor, frame);
            Assert.True(IsPlanted(actor, frame, 0) || IsPlanted(actor, frame, 1), $"frame {frame}");
            for (int side = 0; side < 2; side++)
            {
                if (!IsPlanted(actor, frame, side))
                {
                    height[side] = Math.Max(height[side], ActorMeasures.GetSole(world[(int)Foot(side)]).Min(point => point.Y));
                }
                else if (height[side] >= 0)
                {
                    Assert.InRange(height[side], 1.5f, 15);
                    height[side] = -1;
                    steps++;
                }
            }
        }

        Assert.Equal(32, steps);
    }

    [Fact]
    public void Knees_bend_backwards_only_and_never_lock()
    {
        var actor = new SyntheticSource();
        for (long frame = 0; frame < 60 * ActorMeasures.LapSeconds; frame++)
        {
            BoneTransform[] pose = ActorMeasures.GetPose(actor, frame);
            foreach (Bone shin in (Bone[])[Bone.RightLeg, Bone.LeftLeg])
            {
                Quaternion knee = pose[(int)shin].Rotation;
                Assert.InRange(2 * Math.Atan2(knee.X, knee.W) * (180 / Math.PI), 10, 70);
                Assert.Equal(0, knee.Y, 5);
                Assert.Equal(0, knee.Z, 5);
            }
        }
    }

    [Fact]
    public void A_lap_is_two_rounds_and_ends_where_it_began()
    {
        var actor = new SyntheticSource();
        Vector3 previous = ActorMeasures.GetPose(actor, 0)[0].Position;
        Vector3 start = previous;
        double way = 0;
        int walking = 0;
        for (long frame = 1; frame <= 60 * ActorMeasures.LapSeconds; frame++)
        {
            BoneTransform hips = ActorMeasures.GetPose(actor, frame)[0];
            Vector3 step = (hips.Position - previous) with { Y = 0 };
            way += step.Length();
            previous = hips.Position;
            if (step.Length() < 1)
                continue;

            walking++;
            Assert.True(Vector3.Dot(Vector3.Normalize(step), Vector3.Transform(Vector3.UnitZ, hips.Rotation)) > 0.9f, $"frame {frame}");
        }

        Assert.InRange(way, 1200, 1350);
        Assert.InRange(walking, 600, 1100);
        Assert.True((previous - start).Length() < Millimetre);
    }

    private static IEnumerable<long> Minute(double rate, long start)
    {
        for (long frame = start; frame < start + (60 * rate); frame++)
            yield return frame;
    }

    private static Bone Foot(int side) => side == 0 ? Bone.LeftFoot : Bone.RightFoot;

    private static bool IsPlanted(SyntheticSource actor, long frame, int side)
    {
        (bool left, bool right) = actor.GetFootContacts(frame);
        return side == 0 ? left : right;
    }
}
