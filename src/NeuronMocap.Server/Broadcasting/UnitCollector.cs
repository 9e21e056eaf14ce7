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

    private readonly List<(int End, TimeSpan Time, bool IsCalculation)> _units = [];
    private byte[] _bytes = new byte[64 * 1024];
    private int _length;
    private int _textStart;
    private bool _isText;
    private int _next;
    private long _incompletePackets;

    // Thread-safe.
    public long IncompletePackets => Interlocked.Read(ref _incompletePackets);

    // Arrival time of the bytes that come next.
    public TimeSpan Time { get; set; }

    private int Start => _units.Count > 0 ? _units[^1].End : 0;

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
            Append(packet.Bytes);
        }

        Cut(packet.Kind is PacketKind.Calculation or PacketKind.StudioCalculation);
    }

    public void OnText(ReadOnlySpan<byte> bytes)
    {
        EndBlanks();
        _isText = true;
        _textStart = _length;
        Append(bytes);
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
            int count = Math.Min(bytes.Length, MaxNoiseLength - (_length - Start));
            Append(bytes[..count]);
            bytes = bytes[count..];
            if (_length - Start == MaxNoiseLength)
                Cut();
        }
    }

    // Called when nothing more follows in the piece. At the end of a connection the rest is cut, too.
    public void EndPiece(bool isLast)
    {
        EndBlanks();
        if (isLast && _length > Start)
            Cut();
    }

    // The unit is valid until the next piece.
    public bool TryTake(out ReadOnlySpan<byte> unit, out TimeSpan time, out bool isCalculation)
    {
        if (_next == _units.Count)
        {
            KeepRest();
            unit = default;
            time = default;
            isCalculation = false;
            return false;
        }

        int start = _next == 0 ? 0 : _units[_next - 1].End;
        (int end, time, isCalculation) = _units[_next++];
        unit = _bytes.AsSpan(start, end - start);
        return true;
    }

    // Text without a frame: if it stands directly behind a line, it belongs to that line, whose reader may wait for it.
    private void EndBlanks()
    {
        if (!_isText)
            return;

        _isText = false;
        bool isBehindLine = _textStart == Start && _units.Count > 0 && _length - _textStart <= MaxNoiseLength;
        if (isBehindLine)
            _units[^1] = _units[^1] with { End = _length };
        else
            Cut();
    }

    private void Cut(bool isCalculation = false) => _units.Add((_length, Time, isCalculation));

    private void KeepRest()
    {
        int start = Start;
        _bytes.AsSpan(start, _length - start).CopyTo(_bytes);
        _length -= start;
        _units.Clear();
        _next = 0;
    }

    private void Append(ReadOnlySpan<byte> bytes)
    {
        if (_bytes.Length - _length < bytes.Length)
            Array.Resize(ref _bytes, Math.Max(_length + bytes.Length, 2 * _bytes.Length));

        bytes.CopyTo(_bytes.AsSpan(_length));
        _length += bytes.Length;
    }
}
