using System.Diagnostics;
using NeuronMocap.Bvh;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>
/// Exports every motion packet of the input as a row of a BVH file, with and without filled gaps. The file has the reported number of rows.
/// </summary>
internal sealed class TakeTarget
{
    private readonly PacketScanner _scanner = new();
    private readonly MotionFrame _frame = new(SkeletonFormat.Default);

    public void Run(FuzzInput input)
    {
        Export(input, BvhGapHandling.Skip);
        Export(input, BvhGapHandling.Repeat);
    }

    private void Export(FuzzInput input, BvhGapHandling gaps)
    {
        var file = new MemoryStream();
        var writer = new BvhTakeWriter(file, new BvhTakeOptions { GapHandling = gaps });
        ArraySegment<byte> rest = input.Segment;
        long time = 1;
        while (_scanner.Scan(rest) is { Status: not ScanStatus.NeedMoreData } result)
        {
            if (result is { Status: ScanStatus.Packet, Kind: PacketKind.Motion })
            {
                time += Stopwatch.Frequency / 120;
                _frame.Borrow(new ReceivedPacket(result.Kind, rest.Slice(0, result.Length), time, origin: 0));
                if (writer.Accepts(_frame))
                    writer.Write(_frame);
            }

            rest = rest.Slice(result.Length);
        }

        writer.Dispose();
        input.Found += writer.FrameCount;
        if (writer.FrameCount == 0)
            return;

        var take = BvhDocument.Parse(file.ToArray());
        WrongResultException.ThrowUnless(take.FrameCount == writer.FrameCount, "{0} rows are reported but {1} are written.", writer.FrameCount, take.FrameCount);
        for (int frame = 0; frame < take.FrameCount; frame++)
            input.Digest.Add((long)FloatBits.Sum(take.GetValues(frame)));
    }
}
