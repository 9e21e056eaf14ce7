using NeuronMocap.Protocol;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>
/// Cuts the output of an assembler into the units of a broadcast and keeps every byte. Does not allocate once its buffers have grown.
/// </summary>
/// <param name="keepsIncomplete">Whether the start of a packet that was cut off is kept. Otherwise it is counted.</param>
internal sealed class UnitCollector(bool keepsIncomplete) : IPacketReceiver
{
    // When this many bytes do not belong to a packet, they form a unit and no longer wait for a packet.
    public const int MaxNoiseLength = 16 * 1024;

    private int _textLength;
    private bool _isText;
    private long _incompletePackets;

    // Thread-safe.
    public long IncompletePackets => Interlocked.Read(ref _incompletePackets);

    // The units that are complete. They are removed before the next piece.
    public UnitBatch Units { get; } = new();

    // Arrival time of the bytes that come next.
    public TimeSpan Time { get; set; }

    // OnText has already received the bytes of a line.
    public void OnPacket(in ReceivedPacket packet)
    {
        if (packet.IsText)
        {
            _isText = false;
        }
        else
        {
            EndBlanks();
            Units.Append(packet.Bytes);
        }

        Cut(packet.Kind is PacketKind.Calculation or PacketKind.StudioCalculation);
    }

    public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind)
    {
        EndBlanks();
        _isText = true;
        _textLength = bytes.Length;
        Units.Append(bytes);
    }

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
    {
        EndBlanks();
        if (reason == SkipReason.Incomplete && !keepsIncomplete)
        {
            Interlocked.Increment(ref _incompletePackets);
            return;
        }

        while (bytes.Length > 0)
        {
            int count = Math.Min(bytes.Length, MaxNoiseLength - Units.Rest);
            Units.Append(bytes[..count]);
            bytes = bytes[count..];
            if (Units.Rest == MaxNoiseLength)
                Cut();
        }
    }

    // Called when nothing more follows in the piece. At the end of a connection the rest is cut, too.
    public void EndPiece(bool isLast)
    {
        EndBlanks();
        if (isLast && Units.Rest > 0)
            Cut();
    }

    // Text without a frame: if it stands directly behind a line, it belongs to that line, whose reader may wait for it.
    private void EndBlanks()
    {
        if (!_isText)
            return;

        _isText = false;
        bool isBehindLine = Units.Rest == _textLength && Units.Count > 0 && _textLength <= MaxNoiseLength;
        if (isBehindLine)
            Units.ExtendLast();
        else
            Cut();
    }

    private void Cut(bool isCalculation = false) => Units.Cut(Time, isCalculation);
}
