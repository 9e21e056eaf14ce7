using System.Security.Cryptography;
using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>
/// The result of a stream, line by line: each packet and each rejected header with its place, and the start of the unfinished rest. The places show
/// what was skipped. The portions in which skipped bytes are reported are omitted, because they may depend on the pieces.
/// </summary>
internal sealed class StreamTrace(byte[] stream) : IPacketReceiver
{
    private int _position;
    private int _textAt;

    public List<string> Lines { get; } = [];

    /// <summary>Pushes pieces through an assembler. Each piece has its own memory, which is overwritten afterwards.</summary>
    public static List<string> OfAssembler(byte[] stream, IEnumerable<ArraySegment<byte>> pieces, PacketScanner scanner)
    {
        const int margin = 5;
        var trace = new StreamTrace(stream);
        var assembler = new PacketAssembler(scanner, trace);
        foreach (ArraySegment<byte> piece in pieces)
        {
            byte[] buffer = new byte[piece.Count + (2 * margin)];
            buffer.AsSpan().Fill(0xFF);
            piece.CopyTo(buffer, margin);
            assembler.Push(new ArraySegment<byte>(buffer, margin, piece.Count), timestamp: 0);
            buffer.AsSpan().Fill(0xDD);
        }

        Assert.Equal(stream.Length - trace._position, assembler.PendingBytes);
        trace.End();
        return trace.Lines;
    }

    public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind)
    {
        if (!bytes.SequenceEqual(stream.AsSpan(_position, bytes.Length)))
            Assert.Fail($"The text at {_position} is not what the stream has there.");

        _textAt = _position;
        _position += bytes.Length;
    }

    public void OnPacket(in ReceivedPacket packet)
    {
        if (packet.IsText)
        {
            Lines.Add(Line(packet.Kind, _textAt, packet.Bytes));
            return;
        }

        if (!packet.Bytes.SequenceEqual(stream.AsSpan(_position, packet.Length)))
            Assert.Fail($"The {packet.Kind} packet at {_position} is not what the stream has there.");

        AddPacket(packet.Kind, packet.Length);
    }

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
    {
        if (reason != SkipReason.NoTokens)
            AddRefused(reason);

        _position += bytes.Length;
    }

    private void AddPacket(PacketKind kind, int length)
    {
        Lines.Add($"{kind} at {_position}, {length} bytes");
        _position += length;
    }

    /// <summary>Returns the line for a frame received as text.</summary>
    public static string Line(PacketKind kind, int at, ReadOnlySpan<byte> image) =>
        $"{kind} as text at {at}: {Convert.ToHexString(SHA256.HashData(image.ToArray()))}";

    public void AddRefused(SkipReason reason) => Lines.Add($"{reason} at {_position}");

    public void Skip(int count) => _position += count;

    public void End() => Lines.Add($"the rest at {_position}");
}
