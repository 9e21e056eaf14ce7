using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Infrastructure;

internal sealed record FoundPacket(PacketKind Kind, byte[] Bytes);

/// <summary>
/// Reads a stream with a <see cref="PacketScanner"/> as its contract requires: keeps unused bytes, and waits for the requested length. Checks every
/// answer against the contract.
/// </summary>
internal sealed class ScanAll
{
    private readonly PacketScanner _scanner;
    private byte[] _buffer = [];
    private int _start;
    private int _end;
    private int _wanted = 1;

    public ScanAll(PacketScanner? scanner = null) => _scanner = scanner ?? new PacketScanner();

    public List<FoundPacket> Packets { get; } = [];

    public long Skipped { get; private set; }

    public int UnknownVersions { get; private set; }

    public int TooLarge { get; private set; }

    public int Calls { get; private set; }

    /// <summary>The lengths of answers that requested more bytes, in order.</summary>
    public List<int> Waits { get; } = [];

    /// <summary>The number of bytes that may still become a packet.</summary>
    public int Pending => _end - _start;

    public static ScanAll Of(IEnumerable<ArraySegment<byte>> pieces, PacketScanner? scanner = null)
    {
        var scan = new ScanAll(scanner);
        foreach (ArraySegment<byte> piece in pieces)
            scan.Feed(piece);

        return scan;
    }

    public static ScanAll Of(byte[] bytes, PacketScanner? scanner = null) => Of([new ArraySegment<byte>(bytes)], scanner);

    public void Feed(ReadOnlySpan<byte> piece)
    {
        Append(piece);
        while (Pending >= _wanted)
            Take(_buffer.AsSpan(_start, Pending));
    }

    private void Take(ReadOnlySpan<byte> given)
    {
        ScanResult result = _scanner.Scan(given);
        Calls++;
        Assert.True(result.Length > 0, "An answer of length zero does not advance.");
        if (result.Status == ScanStatus.NeedMoreData)
        {
            Assert.True(result.Length > given.Length, $"{given.Length} bytes are there, {result.Length} were asked for.");
            Waits.Add(result.Length);
            _wanted = result.Length;
            return;
        }

        Assert.True(result.Length <= given.Length, $"An answer of {result.Length} bytes for {given.Length}.");
        _wanted = 1;
        _start += result.Length;
        if (result.Status == ScanStatus.Packet)
            Packets.Add(new FoundPacket(result.Kind, given[..result.Length].ToArray()));
        else
            CountSkip(result);
    }

    private void CountSkip(ScanResult result)
    {
        Assert.Equal(PacketKind.None, result.Kind);
        Skipped += result.Length;
        UnknownVersions += result.Reason == SkipReason.UnknownVersion ? 1 : 0;
        TooLarge += result.Reason == SkipReason.TooLarge ? 1 : 0;
    }

    private void Append(ReadOnlySpan<byte> piece)
    {
        if (_end + piece.Length > _buffer.Length)
        {
            byte[] larger = new byte[Math.Max(4096, 2 * (Pending + piece.Length))];
            _buffer.AsSpan(_start, Pending).CopyTo(larger);
            _buffer = larger;
            _end -= _start;
            _start = 0;
        }

        piece.CopyTo(_buffer.AsSpan(_end));
        _end += piece.Length;
    }
}
