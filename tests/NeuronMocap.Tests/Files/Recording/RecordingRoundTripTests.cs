using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

public sealed class RecordingRoundTripTests
{
    private static readonly DateTimeOffset Start = new(2026, 11, 21, 10, 30, 0, TimeSpan.Zero);

    [Theory, InlineData(false), InlineData(true)]
    public void Every_entry_round_trips(bool compress)
    {
        var file = new MemoryStream();
        var options = new RecordingWriterOptions { StartTime = Start, Compress = compress, LeaveOpen = true };
        using (var writer = new RecordingWriter(file, new RecordingMetadata().With(RecordingMetadata.ServerKey, "studio:7001"), options))
        {
            writer.OpenConnection(Ticks(10), new RecordedConnection(0, TransportKind.Tcp, "127.0.0.1:50000", "127.0.0.1:7001"));
            writer.WriteBytes(Ticks(20), 0, [1, 2, 3]);
            writer.WriteBytes(Ticks(20), 0, [4, 5, 6]);
            writer.WriteBytes(Ticks(2_000_000_000), 0, []);
            writer.WriteLoss(Ticks(2_000_000_001), 0, 3, 4000);
            writer.CloseConnection(Ticks(2_000_000_002), 0, "Reset");
            writer.OpenConnection(Ticks(2_000_000_003), new RecordedConnection(1, TransportKind.Udp, "0.0.0.0:7012", ""));
            writer.AddSender(Ticks(2_000_000_003), 1, 0, "127.0.0.1:4000");
            writer.WriteBytes(Ticks(2_000_000_003), 1, new byte[784]);
            writer.RemoveSender(Ticks(2_000_000_004), 1, 0);
            writer.SetMetadata(Ticks(2_000_000_005), RecordingMetadata.RotationOrderKey, "XYZ");
        }

        using RecordingReader reader = RecordingReader.Open(file);
        Assert.True(reader.IsComplete);
        Assert.Equal(Start, reader.StartTime);
        Assert.Equal(Ticks(2_000_000_005), reader.Duration);
        Assert.Equal(new RecordingTotals(4, 790, 3, 4000), reader.Totals);
        Assert.Equal("XYZ", reader.Metadata[RecordingMetadata.RotationOrderKey]);
        List<RecordedEntry> entries = RecordedEntry.ReadAll(reader);

        Assert.Equal(
            [
                new(RecordingEntryKind.Metadata, 0, 0, 0, "", null, "studio:7001", "server", 0, 0),
                new(RecordingEntryKind.ConnectionOpened, 10, 0, 0, "", new RecordedConnection(0, TransportKind.Tcp, "127.0.0.1:50000", "127.0.0.1:7001"), null, null, 0, 0),
                new(RecordingEntryKind.Bytes, 20, 0, 0, "010203", null, null, null, 0, 0),
                new(RecordingEntryKind.Bytes, 20, 0, 0, "040506", null, null, null, 0, 0),
                new(RecordingEntryKind.Bytes, 2_000_000_000, 0, 0, "", null, null, null, 0, 0),
                new(RecordingEntryKind.BytesLost, 2_000_000_001, 0, 0, "", null, null, null, 3, 4000),
                new(RecordingEntryKind.ConnectionClosed, 2_000_000_002, 0, 0, "", null, "Reset", null, 0, 0),
                new(RecordingEntryKind.ConnectionOpened, 2_000_000_003, 1, 0, "", new RecordedConnection(1, TransportKind.Udp, "0.0.0.0:7012", ""), null, null, 0, 0),
                new(RecordingEntryKind.SenderAdded, 2_000_000_003, 1, 0, "", null, "127.0.0.1:4000", null, 0, 0),
                new(RecordingEntryKind.Bytes, 2_000_000_003, 1, 0, new string('0', 1568), null, null, null, 0, 0),
                new(RecordingEntryKind.SenderRemoved, 2_000_000_004, 1, 0, "", null, null, null, 0, 0),
                new(RecordingEntryKind.Metadata, 2_000_000_005, 0, 0, "", null, "XYZ", "rotation-order", 0, 0),
            ],
            entries);
        Assert.Empty(reader.Problems);
    }

    private static TimeSpan Ticks(long ticks) => new(ticks);
}
