using System.Numerics;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Motion;

public sealed class PoseSmootherTests
{
    private const double Interval = 1 / 60.0;
    private const Bone Probe = Bone.LeftForeArm;

    private static readonly Vector3 Axis = Vector3.Normalize(new Vector3(1, -2, 0.5f));

    private readonly PoseSmoother _smoother = new();
    private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];

    [Fact]
    public void A_resting_bone_stays_where_it_is()
    {
        _smoother.SetAll(new SmoothingSettings(1, 2, 1));
        for (int i = 0; i < 1000; i++)
        {
            Smooth(2.5f, i * Interval);
            Assert.Equal(2.5f, Angle, 1e-5f);
            Assert.Equal(250, Place, 1e-3f);
        }
    }

    // After one time constant, a step is 63 % done; it never overshoots.
    [Theory]
    [InlineData(0.5f, 1 / 500.0)]
    [InlineData(2, 1 / 500.0)]
    [InlineData(4, 1 / 1000.0)]
    public void A_step_is_approached_exponentially(float cutoff, double interval)
    {
        var settings = new SmoothingSettings(cutoff, 0, 1);
        _smoother.SetAll(settings);
        Smooth(0, 0);
        double timeConstant = settings.GetDelay() / 1000;
        float last = 0;
        for (int i = 1; i * interval < 3 * timeConstant; i++)
        {
            Smooth(1, i * interval);
            Assert.InRange(Angle, last, 1);
            Assert.Equal(1 - Math.Exp(-i * interval / timeConstant), Angle, 0.02);
            Assert.Equal(Angle, Place / 100, 1e-4f);
            last = Angle;
        }
    }

    [Theory]
    [InlineData(0.5f)]
    [InlineData(1)]
    [InlineData(3)]
    public void Noise_becomes_smaller_with_the_cutoff(float cutoff)
    {
        var random = new Random(1);
        _smoother.SetAll(new SmoothingSettings(cutoff, 0, 1));
        (double before, double after) = (0, 0);
        for (int i = 0; i < 20_000; i++)
        {
            float noise = (random.NextSingle() - 0.5f) * 0.02f;
            Smooth(noise, i * Interval);
            before += noise * noise;
            after += Signed * Signed;
        }

        // The variance of an exponential mean with the share a is a / (2 - a) of that of its input.
        double share = 2 * Math.PI * cutoff * Interval;
        share /= 1 + share;
        Assert.Equal(share / (2 - share), after / before, 0.15 * share / (2 - share));
    }

    [Fact]
    public void Beta_leaves_less_of_the_delay_and_most_of_the_smoothing()
    {
        double noise = NoiseWith(new SmoothingSettings(1, 2, 1));
        Assert.InRange(noise, 0, 0.35 * NoiseWith(default));
        Assert.True(DelayWith(new SmoothingSettings(1, 2, 1), speed: 3, even: true) < 0.2 * DelayWith(new SmoothingSettings(1, 0, 1), speed: 3, even: true));
    }

    [Theory]
    [InlineData(1, 0, 0.5, true)]
    [InlineData(3, 0, 4, true)]
    [InlineData(3, 0, 4, false)]
    [InlineData(1, 2, 0.5, true)]
    [InlineData(2, 1, 4, true)]
    [InlineData(2, 1, 4, false)]
    public void The_delay_of_a_steady_motion_is_as_computed(float cutoff, float beta, double speed, bool even)
    {
        var settings = new SmoothingSettings(cutoff, beta, 1);

        double measured = DelayWith(settings, speed, even);

        Assert.Equal(settings.GetDelay(speed), measured, 0.02 * settings.GetDelay(speed));
    }

    [Fact]
    public void The_delay_at_rest_is_that_of_the_lowest_cutoff()
    {
        Assert.Equal(1000 / (2 * Math.PI * 2), new SmoothingSettings(2, 5, 1).GetDelay(), 1e-9);
        Assert.Equal(0, default(SmoothingSettings).GetDelay(10));
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(0.51)]
    [InlineData(double.NaN)]
    public void After_a_gap_or_a_step_back_the_filter_starts_again(double step)
    {
        _smoother.SetAll(new SmoothingSettings(0.5f, 0, 1));
        for (int i = 0; i < 60; i++)
            Smooth(0, 5 + (i * Interval));

        double time = 5 + (59 * Interval) + step;
        Smooth(1, time);
        Assert.Equal(1, Angle, 1e-5f);

        // The speed before does not count any more.
        Smooth(1, double.IsNaN(time) ? 20 : time + Interval);
        Assert.Equal(1, Angle, 1e-5f);
    }

    [Fact]
    public void Reset_starts_again_and_an_equal_time_repeats_the_result()
    {
        _smoother.SetAll(new SmoothingSettings(0.5f, 0, 1));
        Smooth(0, 1);
        Smooth(1, 1 + Interval);
        float once = Angle;
        Smooth(1, 1 + Interval);
        Assert.Equal(once, Angle);
        Assert.InRange(once, 0.01f, 0.5f);

        _smoother.Reset();
        Smooth(1, 1 + (2 * Interval));
        Assert.Equal(1, Angle, 1e-5f);
    }

    [Fact]
    public void Each_bone_has_its_own_settings_and_passes_unchanged_without()
    {
        _smoother[Probe] = new SmoothingSettings(0.5f, 0, 1);
        Smooth(0, 0);
        Smooth(1, Interval);

        Assert.InRange(Angle, 0.01f, 0.5f);
        Assert.Equal(Turned(1), _pose[(int)Bone.Head]);
        Assert.True(_smoother[Bone.Head].IsOff);
    }

    [Fact]
    public void The_sign_of_a_quaternion_is_no_motion()
    {
        _smoother.SetAll(new SmoothingSettings(1, 50, 1));
        for (int i = 0; i < 100; i++)
        {
            BoneTransform turned = Turned(1);
            Array.Fill(_pose, i % 2 == 0 ? turned : turned with { Rotation = Quaternion.Negate(turned.Rotation) });
            _smoother.Smooth(_pose, i * Interval);
            Assert.Equal(1, Angle, 1e-5f);
        }
    }

    [Fact]
    public void A_transform_that_is_not_finite_does_not_stay_in_the_filter()
    {
        _smoother.SetAll(new SmoothingSettings(1, 1, 1));
        foreach (int bad in (int[])[0, 5])
        {
            for (int i = 0; i < 10; i++)
            {
                Array.Fill(_pose, Turned(1));
                if (i == bad)
                    _pose[(int)Probe] = new BoneTransform(new Vector3(float.NaN), Quaternion.Identity);

                _smoother.Smooth(_pose, i * Interval);
                Assert.Equal(i == bad, float.IsNaN(_pose[(int)Probe].Position.X));
                Assert.Equal(1, AngleOf(Bone.Head), 1e-5f);
            }

            Assert.Equal(1, Angle, 1e-5f);
            _smoother.Reset();
        }
    }

    [Fact]
    public void Nothing_is_allocated()
    {
        _smoother.SetAll(new SmoothingSettings(1, 1, 1));
        int frame = 0;
        Allocations.AssertNone(() => Smooth(MathF.Sin(frame), frame++ * Interval));
    }

    [Theory]
    [InlineData(-1, 0, 1)]
    [InlineData(float.NaN, 0, 1)]
    [InlineData(1, -1, 1)]
    [InlineData(1, 0, 0)]
    [InlineData(float.PositiveInfinity, 0, 1)]
    public void Wrong_settings_are_refused(float cutoff, float beta, float derivative)
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => _smoother.SetAll(new SmoothingSettings(cutoff, beta, derivative)));
        Assert.Throws<ArgumentOutOfRangeException>(() => _smoother[Bone.Hips] = new SmoothingSettings(cutoff, beta, derivative));
        Assert.Throws<ArgumentException>(() => _smoother.Smooth(new BoneTransform[58], 0));
    }

    private float Angle => AngleOf(Probe);

    // The angle about the axis, with its sign.
    private float Signed => Vector3.Dot(QuaternionMath.TurnBetween(Quaternion.Identity, _pose[(int)Probe].Rotation), Axis);

    private float Place => _pose[(int)Probe].Position.X;

    private static BoneTransform Turned(float angle) => new(new Vector3(100 * angle, 0, 0), Quaternion.CreateFromAxisAngle(Axis, angle));

    private float AngleOf(Bone bone) => QuaternionMath.TurnBetween(Quaternion.Identity, _pose[(int)bone].Rotation).Length();

    private void Smooth(float angle, double time)
    {
        Array.Fill(_pose, Turned(angle));
        _smoother.Smooth(_pose, time);
    }

    // Milliseconds by which the position is behind, after seven seconds of steady motion. Positions may grow without limit; angles may not.
    private static double DelayWith(SmoothingSettings settings, double speed, bool even)
    {
        var random = new Random(3);
        var smoother = new PoseSmoother();
        smoother.SetAll(settings);
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        double time = 0;
        while (time < 7)
        {
            time += even ? Interval : 0.002 + (0.03 * random.NextDouble());
            var rotation = Quaternion.CreateFromAxisAngle(Axis, (float)(speed * time));
            Array.Fill(pose, new BoneTransform(new Vector3((float)(100 * speed * time), 0, 0), rotation));
            smoother.Smooth(pose, time);
        }

        double behind = time - (pose[0].Position.X / (100 * speed));
        double turnedBehind = QuaternionMath.TurnBetween(pose[0].Rotation, Quaternion.CreateFromAxisAngle(Axis, (float)(speed * time))).Length() / speed;
        Assert.Equal(behind, turnedBehind, 0.02 * behind);
        return behind * 1000;
    }

    private static double NoiseWith(SmoothingSettings settings)
    {
        var random = new Random(5);
        var smoother = new PoseSmoother();
        smoother.SetAll(settings);
        var noise = new RotationNoise();
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        for (int i = 0; i < 600; i++)
        {
            Array.Fill(pose, new BoneTransform(Vector3.Zero, Quaternion.CreateFromAxisAngle(Axis, 0.01f * (random.NextSingle() - 0.5f))));
            smoother.Smooth(pose, i * Interval);
            noise.Update(pose, i * Interval);
        }

        return noise.GetDegrees(Probe);
    }
}
