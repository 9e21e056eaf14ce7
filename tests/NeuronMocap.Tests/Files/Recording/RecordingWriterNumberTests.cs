using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

// A writer takes nothing that a reader rejects.
public sealed class RecordingWriterNumberTests
{
    [Theory]
    [InlineData(-1, TransportKind.Tcp)]
    [InlineData(int.MinValue, TransportKind.Udp)]
    [InlineData(0, TransportKind.Udp + 1)]
    [InlineData(0, (TransportKind)(-1))]
    public void A_refused_connection_leaves_the_recording_whole(int number, TransportKind transport) => AssertWhole(writer =>
        Assert.Throws<ArgumentOutOfRangeException>("connection", () => writer.OpenConnection(default, new RecordedConnection(number, transport, "a", "b"))));

    [Fact]
    public void A_refused_sender_leaves_the_recording_whole() => AssertWhole(writer =>
    {
        writer.OpenConnection(default, new RecordedConnection(4, TransportKind.Udp, "a", ""));
        Assert.Throws<ArgumentOutOfRangeException>("sender", () => writer.AddSender(default, 4, -1, "b"));
        Assert.Throws<ArgumentOutOfRangeException>("connection", () => writer.AddSender(default, -4, 0, "b"));
    });

    // The start of a file is a date from the year 1 to the year 9999.
    [Fact]
    public void The_next_file_must_start_at_a_date()
    {
        using var writer = new RecordingWriter(new MemoryStream(), options: new RecordingWriterOptions { StartTime = Recordings.Start });
        using var next = new MemoryStream();
        Assert.Throws<ArgumentOutOfRangeException>("time", () => writer.ContinueIn(next, TimeSpan.MaxValue));
        Assert.Throws<ArgumentOutOfRangeException>("time", () => writer.ContinueIn(next, TimeSpan.MinValue));
        Assert.Throws<ArgumentOutOfRangeException>("time", () => writer.ContinueIn(next, DateTimeOffset.MaxValue - Recordings.Start + Recordings.Ticks(1)));
        Assert.Equal(0, next.Length);

        using RecordingWriter last = writer.ContinueIn(next, DateTimeOffset.MaxValue - Recordings.Start);
        Assert.Equal(DateTimeOffset.MaxValue, last.StartTime);
    }

    private static void AssertWhole(Action<RecordingWriter> refuse)
    {
        const int Pieces = 1000;
        byte[] file = Recordings.Write(writer =>
        {
            refuse(writer);
            for (int i = 0; i < Pieces; i++)
                writer.WriteBytes(Recordings.Ticks(10_000L * i), 0, Recordings.Piece(i, 100));
        });
        using RecordingReader reader = RecordingReader.Open(new MemoryStream(file));
        Same.Items(Enumerable.Range(0, Pieces), Recordings.Numbers(reader, 100));
        Assert.Empty(reader.Problems);
    }
}
