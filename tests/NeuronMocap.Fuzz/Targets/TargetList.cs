using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Recording;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>All parsers. To add one, add a line here.</summary>
internal static class TargetList
{
    public static IReadOnlyList<FuzzTarget> All { get; } =
    [
        new("scanner", CorpusKind.Packets, () => new ScannerTarget().Run),
        new("assembler", CorpusKind.Packets, () => new AssemblerTarget().Run) { AllocatedPerInput = 32 * 1024, AllocatedPerByte = 16 },
        new("text", CorpusKind.Text, () => new AssemblerTarget().Run) { AllocatedPerInput = 64 * 1024, AllocatedPerByte = 16 },
        // Each sender has room for the image of a line.
        new("udp-text", CorpusKind.Text, () => new UdpTarget().Run) { AllocatedPerInput = 3 * UdpTarget.AllocatedForSenders, AllocatedPerByte = UdpTarget.AllocatedPerByte },
        new("udp", CorpusKind.Packets, () => new UdpTarget().Run) { AllocatedPerInput = UdpTarget.AllocatedForSenders, AllocatedPerByte = UdpTarget.AllocatedPerByte },
        new("headers", CorpusKind.Packets, () => HeadersTarget.Run),
        new("frames", CorpusKind.Packets, () => new FramesTarget().Run) { AllocatedPerByte = 16 },
        new("compact", CorpusKind.Poses, () => new CompactPoseTarget().Run) { Share = 0.2 },
        // A frame of 1480 bytes ends with a message of 16 to 20, if a bone came before it.
        new("vmc", CorpusKind.Osc, () => VmcTarget.Run) { Share = 0.3, AllocatedPerByte = 64 },
        new("commands", CorpusKind.Commands, () => new CommandsTarget().Run) { AllocatedPerInput = 512 * 1024, AllocatedPerByte = 64 },
        new("bvh", CorpusKind.Bvh, () => BvhTarget.Run) { Refusal = typeof(BvhFormatException), AllocatedPerInput = 384 * 1024, AllocatedPerByte = 192 },
        new("recording", CorpusKind.Recordings, () => new RecordingTarget().Run)
        {
            Refusal = typeof(RecordingFormatException),
            AllocatedPerInput = RecordingTarget.AllocatedForBlocks,
            AllocatedPerByte = 600,
        },
        new("dump", CorpusKind.Packets, () => new DumpTarget().Run) { Refusal = typeof(PlaybackException), AllocatedPerInput = 512 * 1024, AllocatedPerByte = 16 },
        new("guess", CorpusKind.Packets, () => GuessTarget.Run) { AllocatedPerInput = 128 * 1024 },
        new("requests", CorpusKind.Packets, () => new RequestsTarget().Run) { AllocatedPerInput = 256 * 1024, AllocatedPerByte = 16 },
        new("replies", CorpusKind.Packets, () => new RepliesTarget().Run) { AllocatedPerByte = 32 },
        // There are three changes, each of which may double the take. The result is then written and read again.
        new("bvh-edit", CorpusKind.Bvh, () => BvhEditTarget.Run) { Refusal = typeof(BvhFormatException), AllocatedPerInput = 4 * 1024 * 1024, AllocatedPerByte = 16 * 1024 },
        new("take", CorpusKind.Packets, () => new TakeTarget().Run) { AllocatedPerInput = 4 * 1024 * 1024, AllocatedPerByte = 256 },
        new("play", CorpusKind.Recordings, () => new PlaybackTarget().Run)
        {
            Refusal = typeof(RecordingFormatException),
            AllocatedPerInput = 3 * RecordingTarget.AllocatedForBlocks,
            AllocatedPerByte = 2_000,
        },
#if TOOLS
        .. Tools.ToolTargets.All,
#endif
        // Three readers and a writer have 64 KB each, and lists of repairs are created twice.
        new("calc", CorpusKind.Calculation, () => CalculationTarget.Run)
        {
            Refusal = typeof(CalculationFormatException), AllocatedPerInput = 768 * 1024, AllocatedPerByte = 64,
        },
    ];
}
