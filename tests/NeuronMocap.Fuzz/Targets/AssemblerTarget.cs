using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>The input in pieces of different sizes. Each division must give the same result as the whole input.</summary>
internal sealed class AssemblerTarget
{
    private static readonly int[] LargestPieces = [1, 3, 80, 2_000];

    private readonly PacketScanner _scanner = new(ProtocolConstants.DefaultMaxValues);
    private readonly StreamReading _whole = new();
    private readonly StreamReading _pieces = new();
    private readonly byte[] _received = new byte[FuzzInput.MaxLength];

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
                assembler.Push(Receive(rest.Slice(0, size)), timestamp: 0);
                _received.AsSpan(0, size).Fill(0xFF);
                rest = rest.Slice(size);
            }

            WrongResultException.ThrowUnless(
                _pieces.Position + assembler.PendingBytes == input.Segment.Count,
                "In pieces of up to {0}, {1} bytes are done and {2} pending: not all of them.",
                largest,
                _pieces.Position,
                assembler.PendingBytes);
            WrongResultException.ThrowUnless(
                (_pieces.Digest, _pieces.Position, _pieces.Packets) == (_whole.Digest, _whole.Position, _whole.Packets),
                "In pieces of up to {0}, {1} packets come out, and not what the whole gives, {2}.",
                largest,
                _pieces.Packets,
                _whole.Packets);
        }

        input.Digest.Add(_whole.Digest);
        input.Found += _whole.Packets;
    }

    // Uses memory that the next piece overwrites, like a socket's buffer.
    private ArraySegment<byte> Receive(ArraySegment<byte> piece)
    {
        piece.CopyTo(_received);
        return new ArraySegment<byte>(_received, 0, piece.Count);
    }

    private void ReadWhole(ArraySegment<byte> stream)
    {
        _whole.Begin(stream);
        new PacketAssembler(_scanner, _whole).Push(stream, timestamp: 0);
    }
}
