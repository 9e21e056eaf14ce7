using System.Net.Sockets;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Reader;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Recording;

// Recordings of real readers, over real sockets.
public sealed class StreamRecorderTests : IDisposable
{
    private readonly RecordingFolder _folder = new();
    private readonly TapLog _log = new();

    public void Dispose() => _folder.Dispose();

    [Theory, MemberData(nameof(FixtureReaderTests.Names), MemberType = typeof(FixtureReaderTests))]
    public Task Tcp_is_recorded_as_it_arrived(string name) => RecordTcpAsync(name, 777, new RecordingOptions());

    [Fact]
    public Task Single_bytes_are_recorded_as_they_arrived() => RecordTcpAsync("mixed", 1, new RecordingOptions());

    [Fact]
    public Task A_compressed_recording_is_the_same() => RecordTcpAsync("mixed", int.MaxValue, new RecordingOptions { Compress = true, FlushToDisk = true });

    [Theory, MemberData(nameof(FixtureReaderTests.Names), MemberType = typeof(FixtureReaderTests))]
    public async Task Udp_is_recorded_datagram_by_datagram(string name)
    {
        StreamFixture fixture = StreamFixture.Load(name);
        byte[][] sent = [.. fixture.Bytes.Chunk(1024)];
        await using UdpEnd end = await UdpEnd.StartAsync();
        string local = end.EndPoint.ToString();
        end.Reader.Tap.Add(_log, 0);
        StreamRecorder recorder = end.Reader.StartRecording(_folder.PathOf("udp.nmrec"));
        Socket[] senders = [end.CreateSender(), end.CreateSender()];
        for (int i = 0; i < sent.Length; i++)
            await end.SendAsync(senders[i % 2], sent[i]);

        await Limits.UntilAsync(() => recorder.GetStatistics().Pieces == sent.Length);
        await end.Reader.DisposeAsync();
        List<RecordedEntry> entries = Read("udp.nmrec");

        _log.AssertRecorded(entries);
        Assert.Equal(sent.Select(Convert.ToHexString), entries.Where(entry => entry.Kind == RecordingEntryKind.Bytes).Select(entry => entry.Bytes));
        RecordedConnection opened = Assert.Single(entries, entry => entry.Kind == RecordingEntryKind.ConnectionOpened).Opened!;
        Assert.Equal(new RecordedConnection(0, TransportKind.Udp, local, "") { WasOpen = true }, opened);

        // On a busy machine a sender may pause for so long that the other one counts as its successor. It is added again when it goes on.
        Assert.Equal(
            senders.Take(sent.Length).Select(sender => sender.LocalEndPoint!.ToString()!),
            entries.Where(entry => entry.Kind == RecordingEntryKind.SenderAdded).Select(entry => entry.Text!).Distinct());
    }

    [Fact]
    public async Task Forgotten_senders_are_recorded_again()
    {
        await using UdpEnd end = await UdpEnd.StartAsync();
        StreamRecorder recorder = end.Reader.StartRecording(_folder.PathOf("udp.nmrec"));
        Socket[] senders = [.. Enumerable.Range(0, UdpSenders.Limit + 2).Select(_ => end.CreateSender())];
        foreach (Socket sender in senders)
            await end.SendAsync(sender, new byte[] { 1 });
        await end.SendAsync(senders[0], Array.Empty<byte>());

        await Limits.UntilAsync(() => recorder.GetStatistics().Pieces == senders.Length + 1);
        recorder.Dispose();
        List<RecordedEntry> entries = Read("udp.nmrec");

        Assert.Equal([0, 1, 2], entries.Where(entry => entry.Kind == RecordingEntryKind.SenderRemoved).Select(entry => entry.Sender));
        RecordedEntry[] added = [.. entries.Where(entry => entry.Kind == RecordingEntryKind.SenderAdded)];
        Assert.Equal(Enumerable.Range(0, senders.Length + 1), added.Select(entry => entry.Sender));
        Assert.Equal(added[0].Text, added[^1].Text);
        Assert.Equal("", entries[^1].Bytes);
    }

    [Fact]
    public async Task A_late_recording_notes_the_open_connection()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await reader.WaitForFramesAsync(1);
        StreamRecorder recorder = reader.StartRecording(_folder.PathOf("late.nmrec"));
        await connection.SendAsync(TestPackets.Motion(2));
        await reader.WaitForFramesAsync(2);
        recorder.Dispose();
        await connection.SendAsync(TestPackets.Motion(3));
        await reader.WaitForFramesAsync(3);
        List<RecordedEntry> entries = Read("late.nmrec");

        RecordedConnection opened = Assert.Single(entries, entry => entry.Kind == RecordingEntryKind.ConnectionOpened).Opened!;
        Assert.True(opened.WasOpen);
        Assert.Equal($"127.0.0.1:{server.Port}", opened.Remote);
        Assert.Equal(reader.Status.LocalEndPoint!.ToString(), opened.Local);
        Assert.Equal(Convert.ToHexString(TestPackets.Motion(2)), JoinedBytes(entries));
        Assert.False(recorder.IsRecording);
    }

    [Fact]
    public async Task Every_connection_has_its_number_and_its_end()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options(reconnect: true));
        StreamRecorder recorder = reader.StartRecording(_folder.PathOf("connections.nmrec"));
        reader.Start();
        for (int i = 1; i <= 3; i++)
        {
            using TestConnection connection = await server.AcceptAsync();
            await connection.SendAsync(TestPackets.Motion(i));
            await reader.WaitForFramesAsync(i);
            connection.Close();
        }

        using (TestConnection last = await server.AcceptAsync())
        {
            await last.SendAsync(TestPackets.Motion(4));
            await reader.WaitForFramesAsync(4);
            await reader.DisposeAsync();
        }

        List<RecordedEntry> entries = Read("connections.nmrec");
        Assert.Equal([0, 1, 2, 3], entries.Where(entry => entry.Kind == RecordingEntryKind.ConnectionOpened).Select(entry => entry.Connection));
        Assert.All(entries.Where(entry => entry.Opened is not null), entry => Assert.False(entry.Opened!.WasOpen));
        Assert.Equal(
            ["ClosedByPeer", "ClosedByPeer", "ClosedByPeer", "Requested"],
            entries.Where(entry => entry.Kind == RecordingEntryKind.ConnectionClosed).Select(entry => entry.Text));
        Assert.Equal(Convert.ToHexString(TestPackets.Motions(1, 4)), JoinedBytes(entries));
        Assert.Null(recorder.Failure);
    }

    [Fact]
    public async Task Several_recordings_run_at_a_time()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        StreamRecorder first = reader.StartRecording(_folder.PathOf("first.nmrec"));
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await reader.WaitForFramesAsync(1);
        using StreamRecorder second = reader.StartRecording(_folder.PathOf("second.nmrec"));
        await connection.SendAsync(TestPackets.Motion(2));
        await reader.WaitForFramesAsync(2);
        first.Dispose();
        await connection.SendAsync(TestPackets.Motion(3));
        await reader.WaitForFramesAsync(3);
        await reader.DisposeAsync();

        Assert.Equal(Convert.ToHexString(TestPackets.Motions(1, 2)), JoinedBytes(Read("first.nmrec")));
        Assert.Equal(Convert.ToHexString(TestPackets.Motions(2, 2)), JoinedBytes(Read("second.nmrec")));
    }

    [Fact]
    public async Task An_existing_file_is_kept_unless_it_may_be_overwritten()
    {
        string path = _folder.PathOf("take.nmrec");
        await File.WriteAllTextAsync(path, "precious", TestContext.Current.CancellationToken);
        await using var reader = new NeuronReader("127.0.0.1");
        Assert.Throws<IOException>(() => reader.StartRecording(path));
        Assert.Equal("precious", await File.ReadAllTextAsync(path, TestContext.Current.CancellationToken));
        reader.StartRecording(path, new RecordingOptions { Overwrite = true }).Dispose();
        Assert.NotEmpty(Read("take.nmrec"));
        Assert.Throws<DirectoryNotFoundException>(() => reader.StartRecording(_folder.PathOf("missing/take.nmrec")));
    }

    [Fact]
    public async Task An_ended_reader_cannot_record()
    {
        var reader = new NeuronReader("127.0.0.1");
        StreamRecorder recorder = reader.StartRecording(_folder.PathOf("take.nmrec"));
        await reader.DisposeAsync();
        Assert.True(recorder.Completion.IsCompleted);
        Assert.Throws<ObjectDisposedException>(() => reader.StartRecording(_folder.PathOf("other.nmrec")));
        Assert.Equal(["take.nmrec"], _folder.Files);
        recorder.Dispose();
    }

    [Fact]
    public async Task An_option_out_of_range_is_named()
    {
        await using var reader = new NeuronReader("127.0.0.1");
        AssertFault(new RecordingOptions { QueueSize = 1 }, "QueueSize");
        AssertFault(new RecordingOptions { FlushInterval = TimeSpan.Zero }, "FlushInterval");
        AssertFault(new RecordingOptions { MaxFileSize = 1000 }, "MaxFileSize");
        AssertFault(new RecordingOptions { MaxFileDuration = TimeSpan.Zero }, "MaxFileDuration");
        AssertFault(new RecordingOptions { MaxFiles = 0, MaxFileSize = 1 << 20 }, "MaxFiles");
        AssertFault(new RecordingOptions { MaxFiles = 2 }, "MaxFiles");
        Assert.Empty(_folder.Files);

        void AssertFault(RecordingOptions options, string name) =>
            Assert.StartsWith(name, Assert.Throws<ArgumentException>(() => reader.StartRecording(_folder.PathOf("take.nmrec"), options)).Message, StringComparison.Ordinal);
    }

    private async Task RecordTcpAsync(string name, int pieceSize, RecordingOptions options)
    {
        StreamFixture fixture = StreamFixture.Load(name);
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        reader.Tap.Add(_log, 0);
        StreamRecorder recorder = reader.StartRecording(_folder.PathOf("tcp.nmrec"), options);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendPiecesAsync(fixture.Bytes, pieceSize);
        connection.Close();
        await reader.Completion.Soon();
        Assert.True(recorder.Completion.IsCompleted);
        List<RecordedEntry> entries = Read("tcp.nmrec");

        _log.AssertRecorded(entries);
        Assert.Equal(Convert.ToHexString(fixture.Bytes), JoinedBytes(entries));
        RecordingStatistics statistics = recorder.GetStatistics();
        Assert.Equal((_log.Pieces.Count, fixture.Bytes.Length, 0L), (statistics.Pieces, statistics.Bytes, statistics.LostPieces));
        Assert.Equal(new FileInfo(_folder.PathOf("tcp.nmrec")).Length, statistics.WrittenBytes);
        RecordedConnection opened = Assert.Single(entries, entry => entry.Kind == RecordingEntryKind.ConnectionOpened).Opened!;
        Assert.Equal((false, $"127.0.0.1:{server.Port}"), (opened.WasOpen, opened.Remote));
    }

    private static string JoinedBytes(List<RecordedEntry> entries) =>
        string.Concat(entries.Where(entry => entry.Kind == RecordingEntryKind.Bytes).Select(entry => entry.Bytes));

    // Reads a whole file without faults.
    private List<RecordedEntry> Read(string name)
    {
        using RecordingReader reader = RecordingReader.Open(_folder.PathOf(name));
        List<RecordedEntry> entries = RecordedEntry.ReadAll(reader);
        Assert.True(reader.IsComplete);
        Assert.Empty(reader.Problems);
        Assert.Equal(entries.Count(entry => entry.Kind == RecordingEntryKind.Bytes), reader.Totals!.Value.Pieces);
        return entries;
    }
}
