using System.Numerics;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Motion;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Benchmarks.Macro;

// The cost of one frame from its values to each computed result, on one thread with a hot cache.
internal static class PoseCost
{
    private const int Frames = 64;
    private const double Interval = 1 / 120.0;

    private static readonly ChannelLayout Layout = new(hasDisplacement: true, hasReference: false);

    public static async Task<int> RunAsync(int runs, Report report)
    {
        report.Begin($"Nanoseconds a frame of 59 bones with displacement, against copying its 354 values once; {HotLoop.Rounds} frames a run, {runs} runs.");
        var take = new Take();
        Way[] ways =
        [
            new("values to local", () => HotLoop.Measure(take.Decode)),
            new("local to world", () => HotLoop.Measure(take.ToWorld)),
            new("values to world", () => HotLoop.Measure(i =>
            {
                take.Decode(i);
                ForwardKinematics.ToWorld(take.Pose, take.Pose);
            })),
            new("world to local", () => HotLoop.Measure(take.ToLocal)),
            new("72 positions", () => HotLoop.Measure(take.CopyPositions)),
            new("centre of mass", () => HotLoop.Measure(take.FindCentre)),
            new("velocities", () => HotLoop.Measure(take.FindVelocities)),
            new("foot contacts", () => HotLoop.Measure(new Feet(take).Update)),
            new("interpolate, linear", () => HotLoop.Measure(take.InterpolateLinear)),
            new("interpolate, cubic", () => HotLoop.Measure(take.InterpolateCubic)),
            new("buffer: push and sample", () => HotLoop.Measure(new Retiming(take).PushAndSample)),
            new("compact: encode", () => HotLoop.Measure(take.Encode)),
            new("compact: decode", () => HotLoop.Measure(take.DecodeCompact)),
        ];
        Aim[] aims =
        [
            new("ns/frame", 2000, Way: "values to world"), new("ns/frame", 1000, Way: "compact: encode"), new("ns/frame", 1000, Way: "compact: decode"), new("B/frame", 0),
        ];
        report.Add(await Alternation.RunAsync("one frame", runs, new Way("copy", () => HotLoop.Measure(take.Copy)), ways, aims));
        return report.End();
    }

    private sealed class Take
    {
        private readonly float[][] _values = new float[Frames][];
        private readonly float[] _copy = new float[Layout.ValueCount];
        private readonly Vector3[] _positions = new Vector3[JointPositions.Count];
        private readonly byte[] _bytes = new byte[CompactPose.MaxSize];
        private int _size;
        private readonly BoneVelocity[] _velocities = new BoneVelocity[BoneHierarchy.BoneCount];

        public Take()
        {
            var actor = new SyntheticSource(1 / Interval);
            for (int i = 0; i < Frames; i++)
            {
                _values[i] = new float[Layout.ValueCount];
                Local[i] = new BoneTransform[BoneHierarchy.BoneCount];
                World[i] = new BoneTransform[BoneHierarchy.BoneCount];
                actor.WriteValues(i, Layout, RotationOrder.YXZ, _values[i]);
                actor.GetPose(i, Local[i]);
                ForwardKinematics.ToWorld(Local[i], World[i]);
                Encode(i);
                Compact[i] = _bytes[.._size];
            }
        }

        public BoneTransform[] Pose { get; } = new BoneTransform[BoneHierarchy.BoneCount];

        public BoneTransform[][] Local { get; } = new BoneTransform[Frames][];

        public byte[][] Compact { get; } = new byte[Frames][];

        public BoneTransform[][] World { get; } = new BoneTransform[Frames][];

        public void Encode(int i) => CompactPose.TryEncode(new CompactPoseHeader { FrameIndex = (uint)i }, Local[i % Frames], _bytes, out _size);

        public void DecodeCompact(int i) => CompactPose.TryDecode(Compact[i % Frames], out _, Pose);

        public void Copy(int i) => _values[i % Frames].AsSpan().CopyTo(_copy);

        public void Decode(int i) => PoseDecoder.Decode(_values[i % Frames], Layout, RotationOrder.YXZ, SkeletonBody.GetDefault(), Pose);

        public void ToWorld(int i) => ForwardKinematics.ToWorld(Local[i % Frames], Pose);

        public void ToLocal(int i) => ForwardKinematics.ToLocal(World[i % Frames], Pose);

        public void CopyPositions(int i) => JointPositions.Copy(World[i % Frames], SkeletonBody.GetDefault(), _positions);

        public void FindCentre(int i) => CenterOfMass.Compute(World[i % Frames], SkeletonBody.GetDefault());

        public void FindVelocities(int i)
        {
            int now = (i % (Frames - 2)) + 1;
            PoseVelocity.ComputeCentral(World[now - 1], World[now], World[now + 1], Interval, Interval, _velocities);
        }

        public void InterpolateLinear(int i)
        {
            int now = i % (Frames - 1);
            PoseInterpolation.Linear(Local[now], Local[now + 1], 0.3, Pose);
        }

        public void InterpolateCubic(int i)
        {
            int now = (i % (Frames - 3)) + 1;
            var frames = new CubicPoseWindow
            {
                First = Local[now - 1],
                Second = Local[now],
                Third = Local[now + 1],
                Fourth = Local[now + 2],
                Times = (0, 1, 2, 3),
            };
            PoseInterpolation.Cubic(frames, 1.3, Pose);
        }
    }

    private sealed class Feet(Take take)
    {
        private readonly FootContactEstimator _estimator = new();
        private long _frame;

        public void Update(int i) => _estimator.Update(take.World[i % Frames], SkeletonBody.GetDefault(), _frame++ * Interval);
    }

    private sealed class Retiming(Take take)
    {
        private readonly PoseBuffer _buffer = new();
        private uint _frame;

        public void PushAndSample(int i)
        {
            double time = _frame * Interval;
            _buffer.Push(take.Local[i % Frames], time, _frame++);
            _buffer.Sample(time + 0.001, take.Pose);
        }
    }
}
