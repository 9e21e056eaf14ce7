using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

// Files that were cut off, changed, or created by another program.
public sealed class RecordingDamageTests
{
    private const int Blocks = 6;
    private const int PerBlock = 4;
    private const int Size = 50;

    [Theory, InlineData(false), InlineData(true)]
    public void A_cut_file_is_read_up_to_its_last_whole_block(bool compress)
    {
        var ends = new List<int>();
        byte[] file = Recordings.InBlocks(Blocks, PerBlock, Size, ends, compress);
        for (int length = 0; length < file.Length; length++)
        {
            var cut = new MemoryStream(file, 0, length);
            if (length < RecordingLayout.FileHeaderSize)
            {
                Assert.Throws<RecordingFormatException>(() => RecordingReader.Open(cut));
                continue;
            }

            using RecordingReader reader = RecordingReader.Open(cut);
            Assert.False(reader.IsComplete);
            int whole = ends.Count(end => end <= length) * PerBlock;
            Same.Items(Enumerable.Range(0, whole), Recordings.Numbers(reader, Size));
            Assert.Equal(whole == 0 ? 0 : 10_000 * (whole - 1), reader.Duration.Ticks);
            Assert.InRange(reader.Problems.Count, 0, 1);
        }
    }

    [Theory, InlineData(false), InlineData(true)]
    public void A_changed_bit_costs_at_most_its_block(bool compress)
    {
        var ends = new List<int>();
        byte[] file = Recordings.InBlocks(Blocks, PerBlock, Size, ends, compress);
        for (int i = 0; i < file.Length * 8; i++)
        {
            byte[] changed = [.. file];
            changed[i / 8] ^= (byte)(1 << (i % 8));
            if (i / 8 < RecordingLayout.FileHeaderSize)
            {
                Assert.Throws<RecordingFormatException>(() => RecordingReader.Open(new MemoryStream(changed)));
                continue;
            }

            using RecordingReader reader = RecordingReader.Open(new MemoryStream(changed));
            List<int> numbers = Recordings.Numbers(reader, Size);
            RecordingProblem problem = Assert.Single(reader.Problems);
            Assert.InRange(i / 8, problem.Offset, problem.Offset + problem.Length - 1);
            int hit = ends.FindIndex(end => i / 8 < end);
            bool isFirst = hit == 0 && problem.Offset + problem.Length < ends[0];
            IEnumerable<int> expected = Enumerable.Range(0, Blocks * PerBlock).Where(number => hit < 0 || isFirst || number / PerBlock != hit);
            Same.Items(expected, numbers);
        }
    }

    [Theory]
    [InlineData(1), InlineData(3), InlineData(31), InlineData(32), InlineData(100), InlineData(1000)]
    public void Missing_or_inserted_bytes_cost_at_most_their_block(int count)
    {
        byte[] file = Recordings.InBlocks(20, PerBlock, Size);
        for (int at = 400; at < 1500; at += 13)
        {
            byte[][] changed =
            [
                [.. file[..at], .. file[(at + count)..]],
                [.. file[..at], .. new byte[count], .. file[at..]],
                [.. file[..at], .. Enumerable.Repeat(file[at..(at + 40)], 1 + (count / 40)).SelectMany(part => part).Take(count), .. file[at..]],
            ];
            foreach (byte[] bytes in changed)
            {
                using RecordingReader reader = RecordingReader.Open(new MemoryStream(bytes));
                List<int> numbers = Recordings.Numbers(reader, Size);
                Same.Items(numbers.Order().Distinct(), numbers);
                int mostHit = 2 + (count / (PerBlock * Size));
                Assert.InRange(numbers.Count, (20 - mostHit) * PerBlock, 20 * PerBlock);
                Assert.Equal((20 * PerBlock) - 1, numbers[^1]);
                Assert.InRange(reader.Problems.Count, 1, 100);
            }
        }
    }

    [Fact]
    public void Damage_is_reported_in_place_and_state_is_restored()
    {
        byte[] file = Recordings.Write(writer =>
        {
            writer.OpenConnection(default, new RecordedConnection(3, TransportKind.Tcp, "a", "b"));
            writer.Flush();
            while (writer.WrittenLength < 3 << 20)
                writer.WriteBytes(writer.Duration + Recordings.Ticks(5), 3, new byte[1000]);
        });
        file[RecordingLayout.FileHeaderSize + (2 * RecordingLayout.BlockHeaderSize) + 2] ^= 1;
        List<RecordedEntry> entries = RecordedEntry.ReadAll(file);
        int opened = entries.FindIndex(entry => entry.Kind == RecordingEntryKind.ConnectionOpened);
        Assert.Equal(RecordingEntryKind.Damaged, entries[0].Kind);
        Assert.True(entries[0].LostBytes > 0);
        Assert.True(opened > 1000 && entries[opened].Opened!.WasOpen);
        Assert.Single(entries, entry => entry.Kind == RecordingEntryKind.ConnectionOpened);
    }

    [Fact]
    public void A_recording_inside_a_recording_is_only_content()
    {
        byte[] inner = Recordings.InBlocks(3, PerBlock, Size);
        byte[] file = Recordings.Write(writer =>
        {
            for (int i = 0; i < 3; i++)
            {
                writer.WriteBytes(Recordings.Ticks(i), 0, inner);
                writer.Flush();
            }
        });
        int middle = file.AsSpan().IndexOf(inner) + inner.Length + 100;
        file[middle] ^= 1;
        List<RecordedEntry> entries = RecordedEntry.ReadAll(file);
        Assert.Equal(
            [RecordingEntryKind.Bytes, RecordingEntryKind.Damaged, RecordingEntryKind.Bytes],
            entries.Select(entry => entry.Kind));
        Assert.All(entries.Where(entry => entry.Kind == RecordingEntryKind.Bytes), entry => Assert.Equal(Convert.ToHexString(inner), entry.Bytes));
    }

    [Fact]
    public void Other_files_are_refused_with_the_reason()
    {
        Assert.Contains("not a recording", Refuse("HIERARCHY\nROOT Hips\n"u8.ToArray()), StringComparison.Ordinal);
        Assert.Contains("cut off", Refuse([]), StringComparison.Ordinal);
        byte[] head = Recordings.Write(static _ => { })[..RecordingLayout.FileHeaderSize];
        Assert.Contains("after 63 bytes", Refuse(head[..63]), StringComparison.Ordinal);
        head[8] = 2;
        Assert.Contains("checksum", Refuse(head), StringComparison.Ordinal);
        BitConverter.TryWriteBytes(head.AsSpan(60), Crc32C.Append(0, head.AsSpan(0, 60)));
        Assert.Contains("version 2", Refuse(head), StringComparison.Ordinal);

        static string Refuse(byte[] bytes) => Assert.Throws<RecordingFormatException>(() => RecordingReader.Open(new MemoryStream(bytes))).Message;
    }

    // Right checksums with wrong content, which only happens on purpose.
    [Fact]
    public void A_hostile_file_takes_bounded_memory_and_time()
    {
        byte[] head = Recordings.Write(static _ => { })[..RecordingLayout.FileHeaderSize];
        uint seed = BitConverter.ToUInt32(head, 60);
        byte[] header = new byte[RecordingLayout.BlockHeaderSize];
        var file = new MemoryStream();
        file.Write(head);
        while (file.Length < 4 << 20)
        {
            // Each announces the largest payload, and has a wrong checksum.
            new BlockHeader(BlockKind.Entries, (BlockEncoding)(file.Length % 3), 1, RecordingLayout.MaxPayload, RecordingLayout.MaxTime, 1).Write(header, seed);
            file.Write(header);
        }

        long before = GC.GetAllocatedBytesForCurrentThread();
        using RecordingReader reader = RecordingReader.Open(file);
        Assert.False(reader.TryRead(out _));
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 8 << 20);
        Assert.InRange(reader.Problems.Count, 1, 100);
    }

    [Theory]
    [InlineData("00"), InlineData("80"), InlineData("8000"), InlineData("800000"), InlineData("80000005"), InlineData("8300"), InlineData("81FFFFFFFFFFFFFFFF7F00")]
    [InlineData("0100FF"), InlineData("010002"), InlineData("01000500090000"), InlineData("0600047F6100"), InlineData("80FFFFFFFFFFFFFFFFFF01000000")]
    public void An_invalid_block_ends_at_its_invalid_entry(string payload)
    {
        byte[] head = Recordings.Write(static _ => { })[..RecordingLayout.FileHeaderSize];
        byte[] bytes = Convert.FromHexString(payload);
        byte[] block = new byte[RecordingLayout.BlockHeaderSize + bytes.Length];
        bytes.CopyTo(block, RecordingLayout.BlockHeaderSize);
        new BlockHeader(BlockKind.Entries, BlockEncoding.Plain, 0, bytes.Length, 0, Crc32C.Append(0, bytes)).Write(block, BitConverter.ToUInt32(head, 60));
        using RecordingReader reader = RecordingReader.Open(new MemoryStream([.. head, .. block]));
        Assert.False(reader.TryRead(out _));
        Assert.Contains("no recorder", Assert.Single(reader.Problems).Description, StringComparison.Ordinal);
    }

    [Fact]
    public void Blocks_and_entries_of_a_newer_minor_version_are_skipped()
    {
        byte[] head = Recordings.Write(static _ => { })[..RecordingLayout.FileHeaderSize];
        byte[] unknown = Block(head, (BlockKind)77, 0, 0, new byte[3]);
        byte[] first = Block(head, BlockKind.Entries, 1, 0, Convert.FromHexString("5005031122338001010002AABB"));
        byte[] second = Block(head, BlockKind.Entries, 2, 7, Convert.FromHexString("80000101020102"));
        using RecordingReader reader = RecordingReader.Open(new MemoryStream([.. head, .. unknown, .. first, .. second]));
        List<RecordedEntry> read = RecordedEntry.ReadAll(reader);
        Assert.Equal(["AABB", "0102"], read.Select(entry => entry.Bytes));
        Assert.Equal([6L, 7L], read.Select(entry => entry.Time));
        Assert.Empty(reader.Problems);
    }

    private static byte[] Block(byte[] head, BlockKind kind, uint number, long time, byte[] payload)
    {
        byte[] block = [.. new byte[RecordingLayout.BlockHeaderSize], .. payload];
        new BlockHeader(kind, BlockEncoding.Plain, number, payload.Length, time, Crc32C.Append(0, payload)).Write(block, BitConverter.ToUInt32(head, 60));
        return block;
    }
}
