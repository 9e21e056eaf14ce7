using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Configs;
using BenchmarkDotNet.Jobs;
using BenchmarkDotNet.Toolchains.InProcess.Emit;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Benchmarks.Micro;

/// <summary>The steps of the receive path one by one, on a frame in the processor's cache, compared with a plain copy of the same bytes.</summary>
[MemoryDiagnoser]
public class ReceivePathBenchmarks
{
    // Runs in this process, because a generated project would not know which build of the library is measured.
    internal static IConfig Config => DefaultConfig.Instance
        .AddJob(Job.ShortRun.WithToolchain(InProcessEmitToolchain.Instance))
        .WithArtifactsPath(Path.Combine(Path.GetTempPath(), "NeuronMocap.Benchmarks"));

    private readonly byte[] _packet = TestFrame.Create();
    private readonly byte[] _target = new byte[TestFrame.Size];
    private readonly BoneTransform[] _bones = new BoneTransform[BoneHierarchy.BoneCount];
    private readonly PacketScanner _scanner = new();
    private readonly StreamCounters _counters = new();
    private readonly MotionFrame _frame = new(SkeletonFormat.Default);
    private readonly PacketRing _ring = new(capacity: 8, TestFrame.Size);
    private readonly LatestPacket _newest = new(TestFrame.Size);
    private uint _index;

    private ReceivedPacket Packet => new(PacketKind.Motion, _packet, 0, _packet.Length, _index, 0);

    [Benchmark(Baseline = true)]
    public void Copy() => _packet.AsSpan().CopyTo(_target);

    [Benchmark]
    public ScanResult Scan() => _scanner.Scan(_packet);

    [Benchmark]
    public void Count()
    {
        TestFrame.SetIndex(_packet, ++_index);
        _counters.Count(Packet);
    }

    [Benchmark]
    public MotionHeader DecodeHeader()
    {
        _frame.Borrow(Packet);
        return _frame.Header;
    }

    [Benchmark]
    public void DecodeAllBones()
    {
        _frame.Borrow(Packet);
        _frame.CopyLocalTransforms(_bones);
    }

    [Benchmark]
    public bool PublishAndTakeQueued()
    {
        _ring.TryEnqueue(Packet);
        bool taken = _ring.TryPeek(out _);
        _ring.Release();
        return taken;
    }

    [Benchmark]
    public bool PublishAndTakeNewest()
    {
        _newest.Publish(Packet);
        return _newest.TryTake(out _);
    }
}
