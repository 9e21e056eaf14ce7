using NeuronMocap.Recording;

namespace NeuronMocap.Fuzz.Inputs;

/// <summary>Small recordings.</summary>
internal static class RecordingFixtures
{
    /// <summary>The block marker, block kinds, and numbers at limits in the encoding of the format.</summary>
    public static IReadOnlyList<byte[]> Words { get; } =
    [
        [0xF7, 0x4E, 0x4D, 0x42], .. Enumerable.Range(0, 9).Select(kind => new[] { (byte)kind }), [0x80], [0x81], [0x82], [0x83],
        [0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x7F], [0xFF, 0xFF, 0xFF, 0xFF, 0x07], [0x80, 0x80, 0x40], [0xFF, 0x7F],
        .. ((int[])[-1, 0, 1, 31, 32, 64, 65_536, 1_048_576, 1_048_577, int.MaxValue, int.MinValue]).Select(BitConverter.GetBytes),
        .. ((long[])[-1, 1L << 60, (1L << 60) + 1, long.MaxValue]).Select(BitConverter.GetBytes),
    ];

    public static IReadOnlyList<byte[]> Create()
    {
        byte[] plain = Write(compress: false);
        byte[] packed = Write(compress: true);
        return [plain, packed, plain[..^80], packed[..(packed.Length / 2)], [.. plain, .. packed[64..]]];
    }

    private static byte[] Write(bool compress)
    {
        var file = new MemoryStream();
        var options = new RecordingWriterOptions
        {
            StartTime = new DateTimeOffset(2026, 11, 21, 10, 30, 0, TimeSpan.Zero),
            RecordingId = new Guid(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11),
            Compress = compress,
        };
        var metadata = new RecordingMetadata().With(RecordingMetadata.ServerKey, "studio:7001").With(RecordingMetadata.RotationOrderKey, "YXZ");
        using (var writer = new RecordingWriter(file, metadata, options))
        {
            // A motion packet of 180 values.
            byte[] piece = PacketFixtures.Create()[1];
            for (int connection = 0; connection < 3; connection++)
            {
                TimeSpan time = TimeSpan.FromSeconds(connection);
                writer.OpenConnection(time, new RecordedConnection(connection, (TransportKind)(connection % 2), "127.0.0.1:50000", "127.0.0.1:7001"));
                writer.AddSender(time, connection, 1, "192.168.1.20:4000");
                for (int i = 0; i < 5; i++)
                    writer.WriteBytes(time + TimeSpan.FromMilliseconds(8 * i), connection, piece.AsSpan(0, i == 3 ? 17 : piece.Length), i % 2);

                writer.WriteLoss(time, connection, 3, 4_000);
                writer.Flush();
                writer.SetMetadata(time, $"key {connection}", "value");
                writer.RemoveSender(time, connection, 1);
                writer.CloseConnection(time, connection, "Reset");
            }
        }

        return file.ToArray();
    }
}
