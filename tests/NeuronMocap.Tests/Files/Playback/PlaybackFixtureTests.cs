using System.Net.Sockets;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Reader;

namespace NeuronMocap.Tests.Playback;

// Playing a recording repeats what a live reader received: frames, figures and states.
public class PlaybackFixtureTests
{
    [Theory]
    [MemberData(nameof(FixtureReaderTests.Names), MemberType = typeof(FixtureReaderTests))]
    public async Task Over_tcp(string name)
    {
        byte[] bytes = Load(name).Bytes;
        using var server = new TestServer();
        await using var live = new NeuronReader(server.Options());
        using var log = new FrameLog(live);
        var statuses = new StatusLog(live);
        using var file = new TemporaryFile();
        StreamRecorder recorder = live.StartRecording(file.Path);
        live.Start();
        using TestConnection connection = await server.AcceptAsync();
        byte[][] pieces = [.. Splits.Random(bytes, new Random(name.Length)).Select(static piece => piece.ToArray())];
        foreach (byte[] piece in pieces)
            await connection.SendAsync(piece);

        connection.Close();
        await live.Completion.Soon();
        recorder.Dispose();
        await AssertSameAsync(live, log, statuses, file);
    }

    [Theory]
    [MemberData(nameof(FixtureReaderTests.Names), MemberType = typeof(FixtureReaderTests))]
    public async Task Over_udp(string name)
    {
        byte[][] datagrams = [.. Load(name).Bytes.Chunk(1024)];
        await using UdpEnd end = await UdpEnd.StartAsync(static options => options.SilenceTimeout = TimeSpan.FromSeconds(60));
        using var log = new FrameLog(end.Reader);
        var statuses = new StatusLog(end.Reader);
        using var file = new TemporaryFile();
        StreamRecorder recorder = end.Reader.StartRecording(file.Path);
        Socket sender = end.CreateSender();
        foreach (byte[] datagram in datagrams)
            await end.SendAsync(sender, datagram);

        await end.DrainedAsync();
        await Limits.UntilAsync(() => recorder.GetStatistics().Pieces == datagrams.Length);
        recorder.Dispose();
        using (RecordedFrameReader frames = RecordedFrameReader.Open(file.Path))
        {
            RecordedFrames.ReadAll(frames);
            await end.Reader.UntilAsync(statistics => Figures(statistics) == Figures(frames.GetStatistics()));
        }

        await AssertSameAsync(end.Reader, log, statuses, file);
    }

    /// <summary>Loads a stream. Derived classes load another encoder's streams.</summary>
    internal virtual StreamFixture Load(string name) => StreamFixture.Load(name);

    private static async Task AssertSameAsync(NeuronReader live, FrameLog liveFrames, StatusLog liveStatuses, TemporaryFile file)
    {
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);

        // The recording holds the pauses of a busy machine.
        await using var reader = new NeuronReader(player, new NeuronReaderOptions { SilenceTimeout = Limits.Unexpected });
        using var frames = new FrameLog(reader);
        var statuses = new StatusLog(reader);
        reader.Start();
        await reader.Completion.Soon();

        Assert.Equal(liveFrames.Lines, frames.Lines);
        Assert.Equal(Figures(live.GetStatistics()), Figures(reader.GetStatistics()));
        Assert.Equal(
            live.GetAvatarStatistics().Select(static avatar => avatar with { LastTimestamp = 0, Jitter = default, FrameRate = 0 }),
            reader.GetAvatarStatistics().Select(static avatar => avatar with { LastTimestamp = 0, Jitter = default, FrameRate = 0 }));

        // Over UDP, the live reader's port was bound before the log started.
        ConnectionState[] states = [.. statuses.All.Select(static status => status.State).Distinct()];
        Assert.Equal([ConnectionState.Connecting, ConnectionState.Connected, ConnectionState.Receiving, ConnectionState.Stopped], states);
        Assert.Subset(states.ToHashSet(), liveStatuses.All.Select(static status => status.State).ToHashSet());
        Assert.Equal((ConnectionReason.EndOfRecording, $"The recording {player.FileName} has ended."), (reader.Status.Reason, reader.Status.Message));
        Assert.Equal(
            liveStatuses.All.Last(static status => status.State == ConnectionState.Receiving).Format,
            statuses.All.Last(static status => status.State == ConnectionState.Receiving).Format);
    }

    // Figures that do not depend on the moment.
    private static ReaderStatistics Figures(ReaderStatistics statistics) => statistics with { FirstFrameTimestamp = 0, LastFrameTimestamp = 0 };
}
