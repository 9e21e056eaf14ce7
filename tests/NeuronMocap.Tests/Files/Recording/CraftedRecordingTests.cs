using NeuronMocap.Recording;
using NeuronMocap.Tests.Playback;

namespace NeuronMocap.Tests.Recording;

// Files of an attacker who knows the format and wants to exhaust the reader's memory. Everything in them is right except the numbers.
public sealed class CraftedRecordingTests
{
    private const int Size = 2 << 20;

    // All allocations while the file is read, including garbage, for each of its bytes.
    [Theory]
    [InlineData("connections", 22)]
    [InlineData("senders", 28)]
    [InlineData("senders of connections that come and go", 28)]
    [InlineData("removed senders", 2)]
    [InlineData("metadata", 2)]
    [InlineData("bytes of unknown connections", 32)]
    public void Memory_is_proportional_to_the_file(string content, int mostPerByte)
    {
        using var file = new TemporaryFile(Write(content));
        long before = GC.GetAllocatedBytesForCurrentThread();
        using (RecordedFrameReader frames = RecordedFrameReader.Open(file.Path))
            Assert.False(frames.Read());

        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, (long)mostPerByte * Size);
    }

    [Theory, InlineData("connections"), InlineData("senders")]
    public void Open_connections_are_limited_with_a_reported_problem(string content)
    {
        using RecordingReader reader = RecordingReader.Open(new MemoryStream(Write(content)));
        int opened = 0;
        while (reader.TryRead(out RecordingEntry entry))
            opened += entry.Kind is RecordingEntryKind.ConnectionOpened or RecordingEntryKind.SenderAdded ? 1 : 0;

        Assert.Equal(RecordingLayout.MaxOpen, opened);
        Assert.Contains("More than 1024 connections and senders are open", reader.Problems[0].Description, StringComparison.Ordinal);
    }

    private static byte[] Write(string content)
    {
        var file = new MemoryStream();
        byte[] head = Recordings.Write(static _ => { })[..RecordingLayout.FileHeaderSize];
        file.Write(head);
        uint seed = BitConverter.ToUInt32(head, 60);
        var entries = new EntryEncoder();
        int number = 1;
        for (uint block = 0; file.Length < Size; block++)
        {
            if (block == 0 || content.StartsWith("senders of", StringComparison.Ordinal))
                entries.AddOpened(0, new RecordedConnection(0, TransportKind.Udp, "", ""));

            while (entries.Length < RecordingLayout.BlockSize)
                Add(entries, content, number++);

            if (content.StartsWith("senders of", StringComparison.Ordinal))
                entries.AddClosed(0, 0, "");

            Span<byte> bytes = entries.Block;
            ReadOnlySpan<byte> payload = bytes[RecordingLayout.BlockHeaderSize..];
            BlockKind kind = content == "metadata" ? BlockKind.Checkpoint : BlockKind.Entries;
            new BlockHeader(kind, BlockEncoding.Plain, block, payload.Length, 0, Crc32C.Append(0, payload)).Write(bytes, seed);
            file.Write(bytes);
            entries.Clear();
        }

        return file.ToArray();
    }

    private static void Add(EntryEncoder entries, string content, int number)
    {
        switch (content)
        {
            case "connections":
                entries.AddOpened(0, new RecordedConnection(number, TransportKind.Udp, "", ""));
                break;
            case "removed senders":
                entries.AddSenderRemoved(0, number, number);
                break;
            case "metadata":
                entries.AddMetadata(0, $"{number % 300}", "");
                break;
            case "bytes of unknown connections":
                entries.AddBytes(0, number, number, []);
                break;
            default:
                entries.AddSender(0, 0, number, "");
                break;
        }
    }
}
