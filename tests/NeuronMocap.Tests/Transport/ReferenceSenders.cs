namespace NeuronMocap.Tests.Transport;

/// <summary>
/// What the joiner of datagrams is compared with: one list of bytes for each sender, read again from its start with every datagram. A
/// datagram that begins with a header, or with a named line of text inside another line, ends what its sender left unfinished; of more than 64 senders the one silent longest is given up.
/// </summary>
internal sealed class ReferenceSenders(int maxValues)
{
    private const int Limit = 64;

    // The one silent longest first.
    private readonly List<(int Sender, int Source, byte[] Unfinished, ReferencePlace Place)> _senders = [];
    private int _sources;

    public List<(int Source, byte[] Bytes)> Packets { get; } = [];

    public long Skipped { get; private set; }

    public void Receive(Datagram datagram)
    {
        int index = _senders.FindIndex(known => known.Sender == datagram.Sender);
        (int source, byte[] unfinished, ReferencePlace place) = index >= 0
            ? (_senders[index].Source, _senders[index].Unfinished, _senders[index].Place)
            : (_sources++, [], datagram.Bytes.Length > 1024 ? ReferencePlace.Start : ReferencePlace.Unsure);
        if (index >= 0)
        {
            _senders.RemoveAt(index);
        }
        else if (_senders.Count == Limit)
        {
            Skipped += _senders[0].Unfinished.Length;
            _senders.RemoveAt(0);
        }

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
        _senders.Add((datagram.Sender, source, bytes[^reading.Pending..], reading.Place));
    }

    private bool IsNewBeginning(byte[] unfinished, byte[] datagram) =>
        ReferenceScanner.StartsWithHeader(datagram, maxValues)
        || (unfinished[0] is not (0xFF or 0xCF) && ReferenceText.IsInsideLine(unfinished) && ReferenceText.BeginsTelling(datagram));
}
