using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>
/// The results of a stream: packets, rejected headers and their places. They are equal for the same stream, however it arrives. The portions in which
/// skipped bytes are reported are not compared, because they may depend on the pieces.
/// </summary>
internal sealed class StreamReading : IPacketReceiver
{
    private ArraySegment<byte> _stream;
    private Digest _digest;

    /// <summary>The number of bytes that were delivered or skipped.</summary>
    public int Position { get; private set; }

    public int Packets { get; private set; }

    public ulong Digest => _digest.Value;

    public void Begin(ArraySegment<byte> stream)
    {
        _stream = stream;
        _digest = default;
        Position = 0;
        Packets = 0;
    }

    public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind)
    {
        WrongResultException.ThrowUnless(
            bytes.Length > 0 && bytes.Length <= _stream.Count - Position && bytes.SequenceEqual(_stream.AsSpan(Position, bytes.Length)),
            "The text is not what the stream has at its place.");
        Position += bytes.Length;
    }

    public void OnPacket(in ReceivedPacket packet)
    {
        if (packet.IsText)
        {
            _digest.Add((long)Position);
            _digest.Add(packet.Bytes);
            Packets++;
            return;
        }

        int length = packet.Length;
        WrongResultException.ThrowUnless(length <= _stream.Count - Position, "A packet is longer than what has arrived.");
        WrongResultException.ThrowUnless(
            packet.Bytes.SequenceEqual(_stream.AsSpan(Position, length)), "A packet is not what the stream has at its place.");
        _digest.Add((long)packet.Kind);
        _digest.Add((long)Position);
        _digest.Add((long)length);
        Position += length;
        Packets++;
    }

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
    {
        WrongResultException.ThrowUnless(
            bytes.Length > 0 && bytes.Length <= _stream.Count - Position && bytes.SequenceEqual(_stream.AsSpan(Position, bytes.Length)),
            "Skipped bytes are not what the stream has at their place.");
        if (reason != SkipReason.NoTokens)
        {
            _digest.Add((long)reason);
            _digest.Add((long)Position);
        }

        Position += bytes.Length;
    }
}
