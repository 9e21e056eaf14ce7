using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>The input in pieces of different sizes; each way has to give what the scanner gives for the whole.</summary>
internal sealed class AssemblerTarget
{
    private static readonly int[] LargestPieces = [1, 3, 80, 2_000];

    private readonly PacketScanner _scanner = new(ProtocolConstants.DefaultMaxValues);
    private readonly StreamReading _whole = new();
    private readonly StreamReading _pieces = new();

    public void Run(FuzzInput input)
    {
        ReadWhole(input.Segment);
        foreach (int largest in LargestPieces)
        {
            _pieces.Begin(input.Segment);
            var assembler = new PacketAssembler(_scanner, _pieces);
            ArraySegment<byte> rest = input.Segment;
            while (rest.Count > 0)
            {
                int size = Math.Min(rest.Count, largest == 1 ? 1 : input.Random.Below(largest + 1));
                assembler.Push(rest.Slice(0, size), timestamp: 0);
                rest = rest.Slice(size);
            }

            WrongResultException.ThrowUnless(
                _pieces.Position + assembler.PendingBytes == input.Segment.Count,
                $"In pieces of up to {largest}, {_pieces.Position} bytes are done and {assembler.PendingBytes} pending, of {input.Segment.Count}.");
            WrongResultException.ThrowUnless(
                (_pieces.Digest, _pieces.Position, _pieces.Packets) == (_whole.Digest, _whole.Position, _whole.Packets),
                $"In pieces of up to {largest}, packets and end are {_pieces.Packets} and {_pieces.Position}, not {_whole.Packets} and {_whole.Position}.");
        }

        input.Digest.Add(_whole.Digest);
        input.Found += _whole.Packets;
    }

    private void ReadWhole(ArraySegment<byte> stream)
    {
        _whole.Begin(stream);
        ArraySegment<byte> rest = stream;
        while (_scanner.Scan(rest) is { Status: not ScanStatus.NeedMore } result)
        {
            ArraySegment<byte> found = rest.Slice(0, result.Length);
            if (result.Status == ScanStatus.Packet)
                _whole.OnPacket(new ReceivedPacket(result.Kind, found, Timestamp: 0, Source: 0));
            else
                _whole.OnSkipped(found, result.Reason);

            rest = rest.Slice(result.Length);
        }
    }
}
