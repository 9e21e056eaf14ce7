namespace NeuronMocap.Tests.Transport;

/// <summary>
/// A model for comparison with the joiner of datagrams: one list of bytes for each sender, read again from its start with every datagram. A datagram
/// that starts with a header ends what its sender left unfinished. So does one that starts with a named line of text inside another line. A sender is
/// unknown until one of its datagrams contains the start of a packet or line. With more than 64 senders, the one that has been silent longest without
/// a frame is given up. If all have sent a frame, no new sender is accepted.
/// </summary>
internal sealed class ReferenceSenders(int maxValues)
{
    private const int Limit = 64;

    // The sender that has been silent longest comes first.
    private readonly List<(int Sender, int Source, byte[] Unfinished, ReferencePlace Place, bool HasFrame)> _senders = [];
    private int _sources;

    public List<(int Source, byte[] Bytes)> Packets { get; } = [];

    public long Skipped { get; private set; }

    public void Receive(Datagram datagram)
    {
        int index = _senders.FindIndex(known => known.Sender == datagram.Sender);
        if (index < 0 && !TryMeet(datagram))
        {
            Skipped += datagram.Bytes.Length;
            return;
        }

        (int source, byte[] unfinished, ReferencePlace place, bool hasFrame) = index >= 0
            ? (_senders[index].Source, _senders[index].Unfinished, _senders[index].Place, _senders[index].HasFrame)
            : (_sources++, [], datagram.Bytes.Length > 1024 ? ReferencePlace.Start : ReferencePlace.Unsure, false);
        if (index >= 0)
            _senders.RemoveAt(index);

        if (unfinished.Length > 0 && IsNewBeginning(unfinished, datagram.Bytes))
        {
            Skipped += unfinished.Length;
            unfinished = [];
            place = ReferencePlace.Unsure;
        }

        byte[] bytes = [.. unfinished, .. datagram.Bytes];
        ReferenceReading reading = ReferenceScanner.Read(bytes, maxValues, place);
        Packets.AddRange(reading.Packets.Select(packet => (source, packet.Bytes)));
        Skipped += reading.Skipped;
        hasFrame |= reading.Packets.Any(packet => packet.Kind != PacketKind.Command && packet.Bytes.Length > 64);
        _senders.Add((datagram.Sender, source, bytes[^reading.Pending..], reading.Place, hasFrame));
    }

    private bool TryMeet(Datagram datagram)
    {
        ReferenceReading reading = ReferenceScanner.Read(datagram.Bytes, maxValues, ReferencePlace.Start);
        byte[] rest = datagram.Bytes[^reading.Pending..];
        bool begins = reading.Packets.Count > 0
            || (rest.Length > 0 && (rest[0] is 0xFF or 0xCF ? rest.Length >= 64 : ReferenceText.IsInsideLine(rest)));
        if (!begins || _senders.Count < Limit)
            return begins;

        int silent = _senders.FindIndex(known => !known.HasFrame);
        if (silent < 0)
            return false;

        Skipped += _senders[silent].Unfinished.Length;
        _senders.RemoveAt(silent);
        return true;
    }

    private bool IsNewBeginning(byte[] unfinished, byte[] datagram) =>
        ReferenceScanner.StartsWithHeader(datagram, maxValues)
        || (unfinished[0] is not (0xFF or 0xCF) && ReferenceText.IsInsideLine(unfinished) && ReferenceText.BeginsTelling(datagram));
}
