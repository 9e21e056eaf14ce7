using System.Numerics;
using NeuronMocap.Motion;
using NeuronMocap.Server;

namespace NeuronMocap.Tests.Motion;

public sealed class WalkingDistanceTests
{
    [Fact]
    public void Standing_for_an_hour_covers_no_distance()
    {
        var random = new Random(1);
        var walk = new WalkingDistance();
        for (int i = 0; i < 60 * 3600; i++)
        {
            double time = i / 60.0;
            float Noise() => (random.NextSingle() - 0.5f) * 4;
            walk.Update(new Vector3((3 * (float)Math.Sin(time)) + Noise(), 90 + Noise(), (2 * (float)Math.Cos(0.7 * time)) + Noise()), time);
        }

        Assert.Equal(0, walk.Distance);
        Assert.Equal(0, walk.Speed);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(3)]
    public void A_walk_is_its_length_minus_the_slack(float noise)
    {
        var random = new Random(2);
        var walk = new WalkingDistance();
        for (int i = 0; i <= 6000; i++)
        {
            // 120 cm/s, with the sway of the steps to both sides.
            double time = i / 60.0;
            float Noise() => (random.NextSingle() - 0.5f) * noise;
            walk.Update(new Vector3((2 * (float)Math.Sin(6 * time)) + Noise(), 90, (float)(120 * time) + Noise()), time);
        }

        Assert.Equal(12_000 - 10, walk.Distance, 12_000 * 0.01);
        Assert.Equal(120, walk.Speed, 6.0);
    }

    [Fact]
    public void The_speed_falls_to_zero_after_a_walk()
    {
        var walk = new WalkingDistance();
        for (int i = 0; i <= 600; i++)
            walk.Update(new Vector3(0, 90, Math.Min(i, 300) * 2), i / 60.0);

        Assert.Equal(590, walk.Distance, 1e-2);
        Assert.True(walk.Speed < 0.01, $"{walk.Speed} cm/s");
    }

    [Fact]
    public void The_actors_lap_is_measured()
    {
        // The lap is 42 steps around the ring of fourteen, with stops.
        const int Rate = 60;
        const int Lap = 40 * Rate;
        var actor = new SyntheticSource(Rate);
        BoneTransform[] pose = new BoneTransform[59];
        var walk = new WalkingDistance();
        double path = 0;
        Vector3 last = default;
        for (int frame = 0; frame <= Lap; frame++)
        {
            actor.GetPose(frame, pose);
            Vector3 hips = pose[0].Position with { Y = 0 };
            path += frame == 0 ? 0 : Vector3.Distance(hips, last);
            last = hips;
            walk.Update(pose[0].Position, frame / (double)Rate);
        }

        // The path itself is longer because the hips sway.
        TestContext.Current.TestOutputHelper?.WriteLine($"{walk.Distance} cm of {path}");
        Assert.InRange(walk.Distance, 0.85 * path, path);
    }

    [Fact]
    public void Frames_that_are_not_finite_are_ignored()
    {
        var walk = new WalkingDistance();
        walk.Update(Vector3.Zero, 0);
        walk.Update(new Vector3(float.NaN, 0, 0), 1);
        walk.Update(new Vector3(500, 0, 0), double.NaN);
        walk.Update(new Vector3(float.PositiveInfinity, 0, 0), 1);
        walk.Update(new Vector3(500, 0, 0), 0);
        Assert.Equal(0, walk.Distance);
        walk.Update(new Vector3(110, 0, 0), 1);
        Assert.Equal(100, walk.Distance, 1e-4);
        walk.Reset();
        walk.Update(new Vector3(1000, 0, 0), 2);
        Assert.Equal(0, walk.Distance);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-1)]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void An_invalid_slack_is_refused(float slack) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new WalkingDistance(slack));
}
