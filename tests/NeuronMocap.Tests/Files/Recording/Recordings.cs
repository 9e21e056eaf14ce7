using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

// Creates recordings in memory.
internal static class Recordings
{
    public static readonly DateTimeOffset Start = new(2026, 11, 21, 10, 30, 0, TimeSpan.Zero);

    public static TimeSpan Ticks(long ticks) => new(ticks);

    public static byte[] Write(Action<RecordingWriter> write, bool compress = false, RecordingMetadata? metadata = null)
    {
        var file = new MemoryStream();
        using (var writer = new RecordingWriter(file, metadata, new RecordingWriterOptions { StartTime = Start, Compress = compress }))
            write(writer);

        return file.ToArray();
    }

    // Blocks of a few pieces each. ends receives the end of each block, the last one after the last piece.
    public static byte[] InBlocks(int blocks, int piecesPerBlock, int pieceSize, List<int>? ends = null, bool compress = false) => Write(
        writer =>
        {
            writer.OpenConnection(Ticks(0), new RecordedConnection(0, TransportKind.Tcp, "127.0.0.1:50000", "127.0.0.1:7001"));
            for (int block = 0; block < blocks; block++)
            {
                for (int i = 0; i < piecesPerBlock; i++)
                {
                    int number = (block * piecesPerBlock) + i;
                    writer.WriteBytes(Ticks(10_000L * number), 0, Piece(number, pieceSize));
                }

                writer.Flush();
                ends?.Add((int)writer.WrittenLength);
            }
        },
        compress);

    public static byte[] Piece(int number, int size)
    {
        byte[] piece = new byte[size];
        for (int i = 0; i < size; i++)
            piece[i] = (byte)((number * 7) + (i / 3));

        BitConverter.TryWriteBytes(piece, number);
        return piece;
    }

    // Returns the numbers of the pieces, and checks that each piece is whole.
    public static List<int> Numbers(RecordingReader reader, int size)
    {
        var numbers = new List<int>();
        while (reader.TryRead(out RecordingEntry entry))
        {
            if (entry.Kind != RecordingEntryKind.Bytes)
                continue;

            int number = BitConverter.ToInt32(entry.Bytes);
            Assert.True(entry.Bytes.SequenceEqual(Piece(number, size)));
            Assert.Equal(10_000L * number, entry.Time.Ticks);
            numbers.Add(number);
        }

        return numbers;
    }
}
