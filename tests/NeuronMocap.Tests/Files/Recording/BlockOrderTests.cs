using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

// Whole blocks that were removed, duplicated or moved. All their checksums are right, so only their numbers reveal it.
public sealed class BlockOrderTests
{
    private const int EntryBlocks = 12;
    private const int PerBlock = 3;
    private const int Size = 40;

    // A checkpoint, the entries, the index and the end.
    private const int Blocks = EntryBlocks + 3;

    private static readonly int[] All = [.. Enumerable.Range(0, EntryBlocks * PerBlock)];

    private readonly byte[] _head;
    private readonly byte[][] _blocks;

    public BlockOrderTests()
    {
        byte[] file = Recordings.InBlocks(EntryBlocks, PerBlock, Size);
        _head = file[..RecordingLayout.FileHeaderSize];
        _blocks = [.. Split(file)];
        Assert.Equal(Blocks, _blocks.Length);
    }

    [Fact]
    public void Swapped_blocks_are_read_in_written_order()
    {
        for (int first = 0; first < Blocks; first++)
        {
            for (int second = first + 1; second < Blocks; second++)
            {
                int[] order = [.. Enumerable.Range(0, Blocks)];
                (order[first], order[second]) = (second, first);
                using RecordingReader reader = Open(order);
                Assert.Equal(All, Recordings.Numbers(reader, Size));
                Assert.True(reader.IsComplete);
                Assert.Contains(reader.Problems, problem => Says(problem, $"Block {first} follows block {second}"));
                Assert.DoesNotContain(reader.Problems, problem => Says(problem, "missing") || Says(problem, "twice"));
            }
        }
    }

    [Fact]
    public void A_repeated_block_is_read_once()
    {
        for (int block = 0; block < Blocks; block++)
        {
            for (int at = block + 1; at <= Blocks; at++)
            {
                List<int> order = [.. Enumerable.Range(0, Blocks)];
                order.Insert(at, block);
                using RecordingReader reader = Open(order);
                Assert.Equal(All, Recordings.Numbers(reader, Size));
                Assert.True(reader.IsComplete);
                Assert.Contains($"Block {block} exists twice", Assert.Single(reader.Problems).Description, StringComparison.Ordinal);
            }
        }
    }

    [Fact]
    public void Missing_blocks_are_named_in_a_closed_recording()
    {
        for (int first = 0; first < Blocks - 1; first++)
        {
            for (int last = first; last < Blocks - 1; last++)
            {
                using RecordingReader reader = Open(Enumerable.Range(0, Blocks).Where(block => block < first || block > last));
                int[] expected = [.. All.Where(number => 1 + (number / PerBlock) is var block && (block < first || block > last))];
                Assert.Equal(expected, Recordings.Numbers(reader, Size));
                Assert.True(reader.IsComplete);
                Assert.Equal(EntryBlocks * PerBlock, reader.Totals!.Value.Pieces);
                string blocks = first == last ? $"Block {first} is" : $"Blocks {first} to {last} are";
                Assert.Equal($"{blocks} missing before this one.", Assert.Single(reader.Problems).Description);
            }
        }
    }

    [Fact]
    public void A_missing_block_is_reported_in_place_and_state_is_restored()
    {
        using RecordingReader reader = Open(Enumerable.Range(0, Blocks).Where(block => block != 5));
        List<RecordedEntry> entries = RecordedEntry.ReadAll(reader);
        int damaged = entries.FindIndex(entry => entry.Kind == RecordingEntryKind.Damaged);
        Assert.Equal(4 * PerBlock, entries.Take(damaged).Count(entry => entry.Kind == RecordingEntryKind.Bytes));
        Assert.Single(entries, entry => entry.Kind == RecordingEntryKind.Damaged);
    }

    [Fact]
    public void A_missing_last_block_is_reported()
    {
        using RecordingReader reader = Open(Enumerable.Range(0, Blocks - 1));
        Assert.False(reader.IsComplete);
        Assert.Equal(All, Recordings.Numbers(reader, Size));
        Assert.Contains("last block is missing", Assert.Single(reader.Problems).Description, StringComparison.Ordinal);

        // If the file is cut off before the index, the loss cannot be detected.
        using RecordingReader killed = Open(Enumerable.Range(0, Blocks - 2));
        Assert.Equal(All, Recordings.Numbers(killed, Size));
        Assert.Empty(killed.Problems);
    }

    [Theory, InlineData(1), InlineData(2), InlineData(3)]
    public void Shuffled_and_repeated_blocks_are_read_in_time_order(int seed)
    {
        var random = new Random(seed);
        for (int round = 0; round < 200; round++)
        {
            int[] order = [.. Enumerable.Range(0, random.Next(1, 2 * Blocks)).Select(_ => random.Next(Blocks))];
            using RecordingReader reader = Open(order);
            int[] expected = [.. All.Where(number => order.Contains(1 + (number / PerBlock)))];
            Assert.Equal(expected, Recordings.Numbers(reader, Size));
            for (int i = 0; i < 5; i++)
            {
                int from = random.Next(EntryBlocks * PerBlock);
                reader.Seek(Recordings.Ticks(10_000L * from));
                List<int> numbers = Recordings.Numbers(reader, Size);
                Assert.Equal(expected.Where(number => number >= from && numbers.Contains(number)), numbers);
            }
        }
    }

    [Fact]
    public void Shuffled_blocks_are_found_in_a_damaged_file()
    {
        int[] order = [.. Enumerable.Range(0, Blocks)];
        (order[3], order[8]) = (order[8], order[3]);
        byte[] file = Join(order);
        int end = RecordingLayout.FileHeaderSize + _blocks[..6].Sum(block => block.Length);
        for (int at = RecordingLayout.FileHeaderSize + _blocks[..5].Sum(block => block.Length); at < end; at++)
        {
            byte[] changed = [.. file];
            changed[at] ^= 4;
            using RecordingReader reader = RecordingReader.Open(new MemoryStream(changed));
            Assert.Equal(All.Where(number => 1 + (number / PerBlock) != 5), Recordings.Numbers(reader, Size));
            Assert.DoesNotContain(reader.Problems, problem => Says(problem, "missing"));
            Assert.Contains(reader.Problems, problem => Says(problem, "checksum"));
        }
    }

    // Each header and each payload is right. All have the same number, or decreasing numbers.
    [Theory, InlineData(0), InlineData(-1)]
    public void Hostile_block_numbers_take_bounded_memory_and_time(int step)
    {
        uint seed = BitConverter.ToUInt32(_head, 60);
        var file = new MemoryStream();
        file.Write(_head);
        byte[] block = new byte[RecordingLayout.BlockHeaderSize];
        for (uint i = 0; file.Length < 4 << 20; i++)
        {
            new BlockHeader(BlockKind.Entries, BlockEncoding.Plain, (uint)(1_000_000 + (i * step)), 0, 0, Crc32C.Append(0, [])).Write(block, seed);
            file.Write(block);
        }

        long before = GC.GetAllocatedBytesForCurrentThread();
        using RecordingReader reader = RecordingReader.Open(file);
        Assert.Equal(RecordingEntryKind.Damaged, Assert.Single(RecordedEntry.ReadAll(reader)).Kind);
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 3 * file.Length);
        Assert.InRange(reader.Problems.Count, 1, 100);
    }

    // The look-up reads other blocks into the memory of the block that caused it. It needs a block that is followed by another, to check whether it
    // is whole.
    [Fact]
    public void Too_many_blocks_to_index_are_still_read()
    {
        int missing = 2;
        byte[] file = [.. Join([0, 1, 3, 4]), 1, 2, 3, .. Enumerable.Range(5, Blocks - 5).SelectMany(block => _blocks[block])];
        var walk = new BlockIterator(new BlockFile(new MemoryStream(file)), new RecordingProblems(), maxBlocks: 6);
        var again = new BlockFile(new MemoryStream(file));
        List<uint> read = [];
        while (walk.TryRead(out ArraySegment<byte> payload))
        {
            read.Add(walk.Header.Sequence);
            Assert.True(again.TryReadPayload(walk.Offset, walk.Header, out ArraySegment<byte> expected));
            Assert.Equal(Convert.ToHexString(expected), Convert.ToHexString(payload));
        }

        Assert.Equal(Enumerable.Range(0, Blocks).Where(block => block != missing).Select(static block => (uint)block), read);
    }

    private static bool Says(RecordingProblem problem, string text) => problem.Description.Contains(text, StringComparison.Ordinal);

    private static IEnumerable<byte[]> Split(byte[] file)
    {
        uint seed = BitConverter.ToUInt32(file, 60);
        for (int start = RecordingLayout.FileHeaderSize; start < file.Length;)
        {
            Assert.True(BlockHeader.TryRead(file.AsSpan(start), seed, out BlockHeader header));
            int end = start + RecordingLayout.BlockHeaderSize + header.Length;
            yield return file[start..end];
            start = end;
        }
    }

    private byte[] Join(IEnumerable<int> order) => [.. _head, .. order.SelectMany(block => _blocks[block])];

    private RecordingReader Open(IEnumerable<int> order) => RecordingReader.Open(new MemoryStream(Join(order)));
}
