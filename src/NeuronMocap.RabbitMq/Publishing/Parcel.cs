using NeuronMocap.Protocol;

namespace NeuronMocap.RabbitMq.Publishing;

// A copy of a packet on its way to the broker. Its memory is used again for other packets.
internal sealed class Parcel
{
    private byte[] _bytes = [];
    private int _length;

    public Route Route { get; private set; } = null!;

    public long Number { get; private set; }

    // Microseconds since 1970, UTC.
    public long Captured { get; private set; }

    // Whether the broker has confirmed it.
    public bool IsConfirmed { get; set; }

    public ReadOnlyMemory<byte> Bytes => new(_bytes, 0, _length);

    public void Fill(Route route, long number, long captured, ReadOnlySpan<byte> packet)
    {
        (Route, Number, Captured, IsConfirmed) = (route, number, captured, false);
        if (_bytes.Length < packet.Length)
            _bytes = new byte[packet.Length];

        _length = packet.Length;
        packet.CopyTo(_bytes);
        if (TextLine.IsImage(packet))
            MakeBinary(route.Kind, (uint)number);
    }

    // A line of text has no version, no frame index and no second token, without which no reader takes it.
    private void MakeBinary(PacketKind kind, uint frameIndex)
    {
        if (kind == PacketKind.Motion)
            (MotionHeader.Read(_bytes) with { Version = DataVersion.New, FrameIndex = frameIndex }).Write(_bytes);
        else
            (CalculationHeader.Read(_bytes) with { Version = DataVersion.Calculation, FrameIndex = frameIndex }).Write(_bytes);
    }
}
