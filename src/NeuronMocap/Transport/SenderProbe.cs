using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Examines the first datagram of an unknown sender. Only a datagram with the start of a packet or of a line costs memory.
internal sealed class SenderProbe(PacketScanner packets)
{
    private readonly StreamScanner _scanner = new(packets);

    // Returns null if the datagram has no such start.
    public SenderIdentity? Find(ReadOnlySpan<byte> datagram)
    {
        _scanner.Begin();
        while (datagram.Length > 0)
        {
            StreamScan scan = _scanner.Scan(datagram);
            if (scan.Part == StreamPart.Packet)
                return SenderIdentity.Read(scan.Kind, datagram);
            if (scan.Part == StreamPart.Line)
                return SenderIdentity.Read(scan.Kind, _scanner.Image);
            if (scan.Part == StreamPart.NeedMoreData)
                return FindUnfinished(datagram);

            datagram = datagram[scan.Length..];
        }

        return null;
    }

    private SenderIdentity? FindUnfinished(ReadOnlySpan<byte> rest)
    {
        if (_scanner.IsInsideLine)
            return default(SenderIdentity);

        return rest.Length >= ProtocolConstants.HeaderSize ? SenderIdentity.Read(PacketTokens.KindOf(rest), rest) : null;
    }
}
