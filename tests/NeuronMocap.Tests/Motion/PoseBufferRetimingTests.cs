using System.Numerics;
using NeuronMocap.Motion;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Motion;

// Measures how evenly bones move on a display. The synthetic actor is sent evenly and received with the timing of a real stream.
public sealed class PoseBufferRetimingTests
{
    private const double SettledSeconds = 0.5;

    // So dense that linear interpolation is exact enough.
    private const int TruthRate = 1000;

    private static readonly double[] Arrivals = ArrivalPattern.Create();
    private static readonly BoneTransform[][] Frames = MakeFrames();
    private static readonly Vector3[] Truth = MakeTruth();

    // Measured: 96 to 157 times at 20 ms, 96 to 158 at 40 ms.
    [Theory]
    [InlineData(60, 20)]
    [InlineData(90, 20)]
    [InlineData(120, 20)]
    [InlineData(60, 40)]
    [InlineData(90, 40)]
    [InlineData(120, 40)]
    public void Retiming_makes_motion_fifty_times_smoother(double displayRate, int delay)
    {
        double newest = VelocityNoise(Newest(displayRate), displayRate);
        double withIndex = VelocityNoise(Retimed(displayRate, delay, PoseInterpolationMethod.Cubic, hasIndex: true), displayRate);
        double without = VelocityNoise(Retimed(displayRate, delay, PoseInterpolationMethod.Cubic, hasIndex: false), displayRate);
        double linear = VelocityNoise(Retimed(displayRate, delay, PoseInterpolationMethod.Linear, hasIndex: true), displayRate);

        string figures = FormattableString.Invariant($"newest {newest:F2}, retimed {withIndex:F3}, without index {without:F3}, linear {linear:F3} cm/s");
        TestContext.Current.TestOutputHelper?.WriteLine($"{displayRate} Hz, {delay} ms: {figures}");
        Assert.True(withIndex * 50 < newest, figures);
        Assert.True(without * 50 < newest, figures);
        Assert.True(linear * 20 < newest, figures);
    }

    [Theory]
    [InlineData(60)]
    [InlineData(120)]
    public void The_delay_is_as_configured(double displayRate)
    {
        Vector3[] shown = Retimed(displayRate, 40, PoseInterpolationMethod.Cubic, hasIndex: true);
        Assert.Equal(0.040, FindLag(shown, displayRate), 0.002);
    }

    private static BoneTransform[][] MakeFrames()
    {
        // Walking, at the rate at which frames were sent.
        var actor = new SyntheticSource(1 / ArrivalPattern.Interval);
        var frames = new BoneTransform[ArrivalPattern.FrameCount][];
        for (int i = 0; i < frames.Length; i++)
        {
            frames[i] = new BoneTransform[BoneHierarchy.BoneCount];
            actor.GetPose(i, frames[i]);
        }

        return frames;
    }

    // The position of the hand, which the hips and the whole arm move, at every moment of the display.
    private static Vector3 Shown(BoneTransform[] local)
    {
        BoneTransform[] world = new BoneTransform[BoneHierarchy.BoneCount];
        ForwardKinematics.ToWorld(local, world);
        return world[(int)Bone.RightHand].Position;
    }

    private static IEnumerable<double> Moments(double displayRate) =>
        Enumerable.Range(0, (int)(Arrivals[^1] * displayRate)).Select(i => 0.0033 + (i / displayRate));

    private static Vector3[] Newest(double displayRate) =>
        [.. Moments(displayRate).Select(moment => Shown(Frames[Array.FindLastIndex(Arrivals, arrival => arrival <= moment)]))];

    private static Vector3[] Retimed(double displayRate, int delay, PoseInterpolationMethod interpolation, bool hasIndex)
    {
        var buffer = new PoseBuffer(new PoseBufferOptions { Delay = TimeSpan.FromMilliseconds(delay), Interpolation = interpolation });
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        List<Vector3> shown = [];
        int next = 0;
        foreach (double moment in Moments(displayRate))
        {
            for (; Arrivals[next] <= moment; next++)
                Assert.True(buffer.Push(Frames[next], Arrivals[next], hasIndex ? (uint)next : null));

            PoseOrigin origin = buffer.Sample(moment, pose);
            Assert.True(origin == PoseOrigin.Interpolated || moment < SettledSeconds || (delay < 25 && origin == PoseOrigin.Extrapolated), $"{moment}: {origin}");
            shown.Add(Shown(pose));
        }

        return [.. shown];
    }

    // The root mean square of the difference between shown and true velocity, at the lag that fits best.
    private static double VelocityNoise(Vector3[] shown, double displayRate) =>
        VelocityNoise(shown, displayRate, FindLag(shown, displayRate));

    private static double FindLag(Vector3[] shown, double displayRate)
    {
        double coarse = Enumerable.Range(0, 15).Select(i => i * 0.005).MinBy(lag => VelocityNoise(shown, displayRate, lag));
        return Enumerable.Range(-16, 33).Select(i => coarse + (i * 0.0003)).MinBy(lag => VelocityNoise(shown, displayRate, lag));
    }

    private static double VelocityNoise(Vector3[] shown, double displayRate, double lag)
    {
        double[] moments = [.. Moments(displayRate)];
        double sum = 0;
        int count = 0;
        for (int i = 1; i < shown.Length; i++)
        {
            if (moments[i] < SettledSeconds)
                continue;

            Vector3 expected = TrueHand(moments[i] - lag) - TrueHand(moments[i - 1] - lag);
            sum += (((shown[i] - shown[i - 1]) - expected) * (float)displayRate).LengthSquared();
            count++;
        }

        return Math.Sqrt(sum / count);
    }

    private static Vector3 TrueHand(double seconds)
    {
        double place = Math.Max(seconds, 0) * TruthRate;
        int index = (int)place;
        return Vector3.Lerp(Truth[index], Truth[index + 1], (float)(place - index));
    }

    private static Vector3[] MakeTruth()
    {
        var actor = new SyntheticSource(TruthRate);
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        var hands = new Vector3[(int)(Arrivals[^1] * TruthRate) + 2];
        for (int i = 0; i < hands.Length; i++)
        {
            actor.GetPose(i, pose);
            hands[i] = Shown(pose);
        }

        return hands;
    }
}
