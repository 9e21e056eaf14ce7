using System.Text;
using FsCheck;
using FsCheck.Fluent;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Recording;

// Sizes, times, seeking and checksums as documented in docs/reference/recording.md.
public sealed class RecordingFormatTests
{
    [Fact]
    public void The_checksum_is_CRC_32C()
    {
        // The check value of CRC catalogues.
        Assert.Equal(0xE306_9283, Crc32C.Append(0, "123456789"u8));
        Assert.Equal(0u, Crc32C.Append(0, []));
        byte[] bytes = Recordings.Piece(1, 300);
        for (int split = 0; split <= bytes.Length; split++)
            Assert.Equal(Crc32C.Append(0, bytes), Crc32C.Append(Crc32C.Append(0, bytes.AsSpan(0, split)), bytes.AsSpan(split)));
    }

    [Fact]
    public void The_block_header_checksum_matches_the_document()
    {
        byte[] file = Recordings.Write(static writer => writer.WriteBytes(default, 0, [1, 2, 3]));
        Assert.Equal(Crc32C.Append(0, file.AsSpan(0, 60)), BitConverter.ToUInt32(file, 60));
        Assert.Equal(Crc32C.Append(0, [.. file[..60], .. file[64..92]]), BitConverter.ToUInt32(file, 92));
        Assert.Equal(Crc32C.Append(0, file.AsSpan(96, BitConverter.ToInt32(file, 76))), BitConverter.ToUInt32(file, 88));
    }

    // At 60 Hz with four flushes a second: 15 pieces in a block, with a header of 32 bytes.
    [Theory]
    [InlineData(1480, 4 * 15 + 4 + 32, 0.0044)]
    [InlineData(784, 4 * 15 + 4 + 32, 0.0082)]
    public void The_overhead_is_below_one_percent(int pieceSize, int bytesPerBlock, double most)
    {
        const int PerBlock = 15;
        byte[] piece = new byte[pieceSize];
        var file = new MemoryStream();
        using var writer = new RecordingWriter(file, options: new RecordingWriterOptions { StartTime = Recordings.Start });
        long time = 0;
        for (int block = 0; block < 40; block++)
        {
            long before = writer.WrittenLength;
            for (int i = 0; i < PerBlock; i++)
                writer.WriteBytes(Recordings.Ticks(time += 166_667), 0, piece);

            writer.Flush();

            // The first piece of a block also has its sender and its length. Its time is in the header.
            Assert.Equal(bytesPerBlock - 2, writer.WrittenLength - before - (PerBlock * pieceSize));
        }

        Assert.InRange((bytesPerBlock - 2.0) / (PerBlock * pieceSize), 0, most);
    }

    [Fact]
    public void Checkpoints_index_and_end_are_below_one_per_mille()
    {
        RecordingMetadata metadata = RecordingMetadata.Empty.With("notes", new string('x', 3000));
        long bytes = 0;
        byte[] file = Recordings.Write(
            writer =>
            {
                byte[] piece = new byte[RecordingLayout.BlockSize];
                for (long time = 0; bytes < 32 << 20; bytes += piece.Length)
                    writer.WriteBytes(Recordings.Ticks(time += 50_000), 0, piece);
            },
            metadata: metadata);

        // The fixed allowance, and 41 bytes for each block of one piece.
        long fixedPart = 16 * 1024 + (41 * (bytes / RecordingLayout.BlockSize));
        Assert.InRange(file.Length - bytes, 41 * (bytes / RecordingLayout.BlockSize), fixedPart + (bytes / 1000) + 4096);
    }

    [Theory, InlineData(false), InlineData(true)]
    public void Seeking_finds_every_place(bool compress)
    {
        const int Count = 4000;
        const int Size = 1000;
        byte[] file = Recordings.Write(
            writer =>
            {
                writer.OpenConnection(default, new RecordedConnection(0, TransportKind.Tcp, "a", "b"));
                for (int i = 0; i < Count; i++)
                    writer.WriteBytes(Recordings.Ticks(10_000L * i), 0, Recordings.Piece(i, Size));
            },
            compress);
        byte[] cut = file[..(file.Length - 3)];
        using RecordingReader whole = RecordingReader.Open(new MemoryStream(file));
        using RecordingReader crashed = RecordingReader.Open(new MemoryStream(cut));
        Assert.True(whole.IsComplete && !crashed.IsComplete);
        foreach (RecordingReader reader in (RecordingReader[])[whole, crashed])
        {
            Assert.Equal(10_000L * (Count - 1), reader.Duration.Ticks);
            // Far apart, and around the checkpoints. Each checkpoint has the time of the piece before it.
            foreach (int first in (int[])[Count - 1, 0, 1, 17, 1999, 1000, 3998, Count, .. Enumerable.Range(1000, 100), .. Enumerable.Range(3100, 100)])
            {
                // Between two pieces, and exactly on one.
                foreach (long time in (long[])[(10_000L * first) - 1, 10_000L * first])
                {
                    reader.Seek(Recordings.Ticks(Math.Max(0, time)));
                    bool isOpen = false;
                    int next = first;
                    while (next < Math.Min(first + 3, Count) && reader.TryRead(out RecordingEntry entry))
                    {
                        isOpen |= entry.Kind == RecordingEntryKind.ConnectionOpened;
                        if (entry.Kind == RecordingEntryKind.Bytes)
                            Assert.Equal((true, next++), (isOpen, BitConverter.ToInt32(entry.Bytes)));
                    }

                    Assert.Equal(Math.Min(first + 3, Count), next);
                }
            }

            reader.Seek(TimeSpan.FromDays(1));
            while (reader.TryRead(out RecordingEntry entry))
                Assert.NotEqual(RecordingEntryKind.Bytes, entry.Kind);

            reader.Seek(TimeSpan.Zero);
            Same.Items(Enumerable.Range(0, Count), Recordings.Numbers(reader, Size));
            Assert.Throws<ArgumentOutOfRangeException>(() => reader.Seek(Recordings.Ticks(-1)));
        }
    }

    [Fact]
    public void The_index_of_a_long_file_stays_small()
    {
        var index = new RecordingIndex();
        for (int i = 0; i < 100_000; i++)
            index.Add(i * 10L, 64 + (i * 1000L));

        Assert.InRange(index.Count, 2000, 4096);
        var buffer = new ByteBuffer(16);
        index.Write(buffer);
        Assert.InRange(buffer.Length, 1, RecordingLayout.MaxPayload);
        var read = new RecordingIndex();
        Assert.True(read.TryRead(buffer.Written, 64 + 100_000_000));
        for (int i = 0; i < 1_000_000; i += 777)
        {
            long place = read.Find(i);
            Assert.Equal(index.Find(i), place);
            Assert.InRange(i - ((place - 64) / 100), 0, 640);
        }
    }

    [Fact]
    public void Decreasing_times_and_invalid_numbers_are_refused()
    {
        byte[] file = Recordings.Write(writer =>
        {
            writer.WriteBytes(Recordings.Ticks(100), int.MaxValue, [1], int.MaxValue);
            writer.WriteBytes(Recordings.Ticks(50), 0, [2]);
            Assert.Throws<ArgumentException>(() => writer.WriteBytes(default, -1, [3]));
            Assert.Throws<ArgumentException>(() => writer.WriteBytes(default, 0, [3], -1));
            Assert.Throws<ArgumentException>(() => writer.WriteBytes(default, 0, new byte[RecordingWriter.MaxPieceLength + 1]));
            Assert.Throws<InvalidOperationException>(() => writer.CloseConnection(default, 4, ""));
            Assert.Throws<InvalidOperationException>(() => writer.AddSender(default, 4, 0, ""));
            writer.OpenConnection(default, new RecordedConnection(4, TransportKind.Udp, new string('ü', 300), ""));
            Assert.Throws<InvalidOperationException>(() => writer.OpenConnection(default, new RecordedConnection(4, TransportKind.Udp, "", "")));
            writer.WriteBytes(default, 4, new byte[RecordingWriter.MaxPieceLength]);
        });
        List<RecordedEntry> entries = RecordedEntry.ReadAll(file);
        Assert.Equal([100L, 100, 100, 100], entries.Select(entry => entry.Time));
        Assert.Equal((int.MaxValue, int.MaxValue), (entries[0].Connection, entries[0].Sender));
        Assert.InRange(Encoding.UTF8.GetByteCount(entries[2].Opened!.Local), 253, 255);
        Assert.Equal(2 * RecordingWriter.MaxPieceLength, entries[3].Bytes.Length);
    }

    [Fact]
    public void Metadata_have_limits()
    {
        RecordingMetadata metadata = RecordingMetadata.Empty.With("a", "1").With("b", "2").With("a", "3");
        Assert.Equal(["a=3", "b=2"], metadata.Values.Select(pair => $"{pair.Key}={pair.Value}"));
        Assert.Null(metadata["c"]);
        Assert.Throws<ArgumentException>(() => metadata.With("", "1"));
        Assert.Throws<ArgumentException>(() => metadata.With(new string('k', 256), "1"));
        Assert.Throws<ArgumentException>(() => metadata.With("k", new string('v', RecordingMetadata.MaxValueBytes + 1)));
        for (int i = metadata.Values.Count; i < RecordingMetadata.MaxCount; i++)
            metadata = metadata.With($"key {i}", "v");
        Assert.Throws<ArgumentException>(() => metadata.With("one more", "v"));
        for (int i = 2; i < 9; i++)
            metadata = metadata.With($"key {i}", new string('v', RecordingMetadata.MaxValueBytes));
        Assert.Throws<ArgumentException>(() => metadata.With("key 10", new string('v', RecordingMetadata.MaxValueBytes)));

        byte[] file = Recordings.Write(static _ => { }, metadata: metadata);
        using RecordingReader reader = RecordingReader.Open(new MemoryStream(file));
        Assert.Equal(metadata.Values, reader.Metadata.Values);
        Assert.Empty(reader.Problems);
    }

    [Fact]
    public void Late_metadata_is_found_in_an_unfinished_file()
    {
        byte[] file = Recordings.Write(writer =>
        {
            writer.WriteBytes(default, 0, new byte[100]);
            writer.SetMetadata(default, RecordingMetadata.SkeletonVariantKey, "Spine3");
            writer.WriteBytes(default, 0, new byte[100]);
        });
        using RecordingReader reader = RecordingReader.Open(new MemoryStream(file[..^10]));
        Assert.False(reader.IsComplete);
        Assert.Equal(SkeletonVariant.Spine3, reader.Metadata.SkeletonVariant);
        Assert.Null(reader.Metadata.RotationOrder);
    }

    [Fact]
    public void Random_entries_round_trip()
    {
        Gen<(int Kind, int Delta, int Number, int Size)> entry =
            from kind in Gen.Choose(0, 9)
            from delta in Gen.Frequency((3, Gen.Choose(0, 200_000)), (1, Gen.Choose(0, int.MaxValue)))
            from number in Gen.Choose(0, 3)
            from size in Gen.Frequency((4, Gen.Choose(0, 2000)), (1, Gen.Elements(784, 1480)), (1, Gen.Choose(0, 70_000)))
            select (kind, delta, number, size);
        Properties.Hold(
            from compress in Gen.Elements(false, true) from count in Gen.Choose(0, 80) from entries in entry.ArrayOf(count) select (compress, entries),
            sample => Properties.SimplerLists(sample.entries, static _ => []).Select(entries => (sample.compress, entries)),
            count: 300,
            sample =>
            {
                var script = new EntryScript();
                byte[] file = Recordings.Write(writer => script.Write(writer, sample.entries), sample.compress);
                using RecordingReader reader = RecordingReader.Open(new MemoryStream(file));
                Assert.Equal(script.Expected, RecordedEntry.ReadAll(reader));
                Assert.Empty(reader.Problems);
                Assert.Equal(script.Expected.LastOrDefault()?.Time ?? 0, reader.Duration.Ticks);
            });
    }

    // Includes the 7 blocks. Checkpoints, which cost a little, come only after a megabyte.
    [Fact]
    public void Writing_a_piece_allocates_nothing()
    {
        var file = new MemoryStream(1 << 20);
        using var writer = new RecordingWriter(file);
        byte[] piece = new byte[60];
        Allocations.AssertNone(() => writer.WriteBytes(writer.Duration, 0, piece), calls: 5000);
    }
}
