using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Server;
using NeuronMocap.Server.Osc;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Benchmarks.Macro;

// The cost of one frame of one avatar for other programs: from the frame to the bytes of its datagrams, on one thread with a hot cache.
internal static class PoseMessages
{
    private const int Frames = 64;
    private const double Interval = 1 / 120.0;

    private static readonly ChannelLayout Layout = new(hasDisplacement: true, hasReference: false);

    public static async Task<int> RunAsync(int runs, Report report)
    {
        report.Begin($"Nanoseconds a frame of 59 bones with displacement, against copying its packet of 1480 bytes once; {HotLoop.Rounds} frames a run, {runs} runs.");
        MotionFrame[] frames = CreateFrames();
        byte[] copy = new byte[frames[0].Packet.Length];
        byte[] compact = new byte[CompactPose.MaxSize];
        var poses = new AvatarPoses(new AvatarChoice(index: null, name: null, onlyOne: false));
        Way[] ways =
        [
            new("compact pose", () => HotLoop.Measure(i => CompactPose.TryEncode(frames[i % Frames], compact, out _))),
            new("VMC", () => Measure(new VmcEncoder(scale: 1, movesRoot: false, start: 0))),
            new("OSC, world", () => Measure(new OscPoseEncoder(poses, "/neuron", OscSpace.World, scale: 1, start: 0))),
            new("OSC, local", () => Measure(new OscPoseEncoder(poses, "/neuron", OscSpace.Local, scale: 1, start: 0))),
        ];
        Aim[] aims = [new("ns/frame", 15_000), new("B/frame", 0)];
        report.Add(await Alternation.RunAsync("one frame", runs, new Way("copy", () => HotLoop.Measure(i => frames[i % Frames].Packet.CopyTo(copy))), ways, aims));
        return report.End();

        Measurements Measure(IPoseEncoder encoder)
        {
            var pose = new AvatarPose(sender: 0, index: 0);
            var bundle = new OscBundle(1400, static (_, _) => { });
            return HotLoop.Measure(i =>
            {
                pose.Take(frames[i % Frames]);
                if (!encoder.TryEncode(pose, bundle))
                    throw new InvalidOperationException("The pose was rejected.");
            });
        }
    }

    private static MotionFrame[] CreateFrames()
    {
        var actor = new SyntheticSource(1 / Interval);
        float[] values = new float[Layout.ValueCount];
        var frames = new MotionFrame[Frames];
        for (int i = 0; i < Frames; i++)
        {
            actor.WriteValues(i, Layout, RotationOrder.YXZ, values);
            frames[i] = new MotionFrame(new MotionHeader { HasDisplacement = true, AvatarName = new AvatarName("Char00"), FrameIndex = (uint)i }, values);
        }

        return frames;
    }
}
