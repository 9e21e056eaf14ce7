using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

/// <summary>Reading a hostile recording costs a bounded number of bytes for each of its own. The bytes are counted, not timed.</summary>
public class RecordingWorkTests
{
    private const int Blocks = 2_000;

    // The bytes examined to find the next block, and again when the file is read after the search.
    private const long MostOfEachBlock = 8 * 4096;

    // Payloads that are checked although another block may start inside them.
    private const long MostLookedInto = 17 * 1024 * 1024;

    [Theory]
    [InlineData(0, 0)]
    [InlineData(0, 1)]
    [InlineData(1, 1)]
    [InlineData(40, 3)]
    public void Garbage_between_blocks_is_read_a_few_times(int length, int garbage)
    {
        byte[] file = CreateFile(size: length + garbage, length);
        Assert.InRange(CountRead(file), file.Length, Blocks * MostOfEachBlock);
    }

    // Each header announces a payload that spans thousands of others.
    [Theory]
    [InlineData(10_000)]
    [InlineData(60_000)]
    public void Overlapping_blocks_are_read_a_bounded_number_of_times(int length)
    {
        byte[] file = CreateFile(size: 1, length);
        Assert.InRange(CountRead(file), file.Length, (Blocks * MostOfEachBlock) + MostLookedInto);
    }

    [Fact]
    public void Markers_without_blocks_are_read_once()
    {
        byte[] file = [.. Head(out _), .. Enumerable.Range(0, 100_000).SelectMany(static _ => BlockHeader.Marker.ToArray())];
        Assert.InRange(CountRead(file), file.Length, 8L * file.Length);
    }

    private static byte[] CreateFile(int size, int length)
    {
        byte[] head = Head(out uint seed);
        byte[] block = new byte[RecordingLayout.BlockHeaderSize + size];
        new BlockHeader(BlockKind.Entries, BlockEncoding.Plain, 0, length, 0, Checksum: 1).Write(block, seed);
        return [.. head, .. Enumerable.Range(0, Blocks).SelectMany(_ => block), .. new byte[length]];
    }

    // The head of a recording without entries.
    private static byte[] Head(out uint seed)
    {
        var file = new MemoryStream();
        new RecordingWriter(file, RecordingMetadata.Empty).Dispose();
        byte[] head = file.ToArray()[..RecordingLayout.FileHeaderSize];
        RecordingHeader.Read(head, out seed);
        return head;
    }

    private static long CountRead(byte[] file)
    {
        using var stream = new CountingStream(file);
        using RecordingReader reader = RecordingReader.Open(stream);
        while (reader.TryRead(out _))
        {
            // To the end.
        }

        return stream.BytesRead;
    }

    private sealed class CountingStream(byte[] bytes) : MemoryStream(bytes, writable: false)
    {
        public long BytesRead { get; private set; }

        // Reads of spans also come here.
        public override int Read(byte[] buffer, int offset, int count)
        {
            int read = base.Read(buffer, offset, count);
            BytesRead += read;
            return read;
        }
    }
}
