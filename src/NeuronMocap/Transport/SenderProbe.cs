using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Looks at the first datagram of somebody unknown: only one that holds the beginning of a packet or of a line costs memory.
internal sealed class SenderProbe(PacketScanner packets)
{
    private readonly StreamScanner _scanner = new(packets);

    // Null where it holds none.
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
