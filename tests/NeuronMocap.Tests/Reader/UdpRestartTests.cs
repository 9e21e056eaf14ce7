using System.Diagnostics;
using System.Net.Sockets;
using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// A restarted server sends from another port of its address.
public sealed class UdpRestartTests : IDisposable
{
    // The first index of frames that no server sent.
    private const int ForgedFrame = 5000;

    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("neuron-udp-restart");

    private string Target => Path.Combine(_folder.FullName, "take.bvh");

    private string Recording => Path.Combine(_folder.FullName, "take.nmrec");

    public void Dispose() => _folder.Delete(recursive: true);

    // Nothing follows from the index of the second run: it may be slightly lower than the last one, like that of a late frame.
    [Theory]
    [InlineData(240, 240)]
    [InlineData(30, 30)]
    public async Task A_restarted_server_continues_the_exported_file(int before, int after)
    {
        await using UdpEnd end = await UdpEnd.StartAsync();
        using BvhExport export = end.Reader.ExportBvh(Target, new BvhExportOptions { FrameTime = BvhFrameTime.Default });
        await SendAsync(end, end.CreateSender(), before);
        await SendAsync(end, end.CreateSender(), after);
        await end.Reader.WaitForFramesAsync(before + after);
        export.Dispose();

        Assert.Equal((0L, 0L), (export.FramesIgnored, export.FramesDropped));
        Assert.Equal(before + after, BvhDocument.Load(Target).FrameCount);
        AvatarStatistics avatar = Assert.Single(end.Reader.GetAvatarStatistics());
        Assert.Equal((0, before + after, 1L, 0L, 0L), (avatar.Sender, avatar.Frames, avatar.Restarts, avatar.Lost, avatar.OutOfOrder));
    }

    // The stop may come before or after the wait for the old port's silence.
    [Fact]
    public async Task Waiting_frames_are_counted_when_the_reader_stops()
    {
        await using UdpEnd end = await UdpEnd.StartAsync();
        await SendAsync(end, end.CreateSender(), 10);
        await end.Reader.WaitForFramesAsync(10);
        await SendAsync(end, end.CreateSender(), 10);
        await end.DrainedAsync();
        await end.Reader.DisposeAsync();

        ReaderStatistics statistics = end.Reader.GetStatistics();
        Assert.InRange(statistics.MotionFrames + statistics.Undelivered, 19, 20);
    }

    [Fact]
    public Task Two_active_servers_of_a_computer_stay_separate() => WithoutPausesAsync(async (end, pauses) =>
    {
        using BvhExport export = end.Reader.ExportBvh(Target, new BvhExportOptions { FrameTime = BvhFrameTime.Default, Overwrite = true });
        Socket[] servers = [end.CreateSender(), end.CreateSender()];
        for (int i = 0; i < 200; i++)
        {
            foreach (Socket server in servers)
                await end.SendAsync(server, TestPackets.Motion(i));
        }

        await end.Reader.WaitForFramesAsync(400);
        export.Dispose();
        if (pauses.HasAny)
            return;

        Assert.Equal([(0, 200L), (1, 200L)], end.Reader.GetAvatarStatistics().Select(avatar => (avatar.Sender, avatar.Frames)));
        Assert.Equal(200, BvhDocument.Load(Target).FrameCount);
    });

    [Fact]
    public Task A_flood_from_the_servers_address_leaves_its_export_complete() => WithoutPausesAsync(async (end, pauses) =>
    {
        const int Frames = 300;
        using BvhExport export = end.Reader.ExportBvh(Target, new BvhExportOptions { FrameTime = BvhFrameTime.Default, Overwrite = true });
        Socket server = end.CreateSender();
        for (int i = 0; i < Frames; i++)
        {
            await end.SendAsync(server, TestPackets.Motion(i));
            for (int forged = 0; forged < 4; forged++)
            {
                using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
                socket.Connect(end.EndPoint);
                await end.SendAsync(socket, TestPackets.Motion(ForgedFrame + i, avatar: forged));
            }
        }

        await end.DrainedAsync();
        await end.Reader.UntilAsync(_ => pauses.HasAny || end.Reader.GetAvatarStatistics() is [{ Frames: Frames }, ..]);
        export.Dispose();
        if (pauses.HasAny)
            return;

        Assert.Equal(Frames, BvhDocument.Load(Target).FrameCount);
        Assert.Equal(Frames, export.FramesWritten);
    });

    [Fact]
    public async Task A_recording_plays_back_as_the_same_stream()
    {
        await using (UdpEnd end = await UdpEnd.StartAsync())
        {
            using StreamRecorder recorder = end.Reader.StartRecording(Recording);
            await SendAsync(end, end.CreateSender(), 60);
            await SendAsync(end, end.CreateSender(), 60);
            await end.Reader.WaitForFramesAsync(120);
        }

        using (var frames = RecordedFrameReader.Open(Recording))
        {
            List<(int Sender, uint? Index)> read = [];
            while (frames.Read())
                read.Add((frames.Frame.Sender, frames.Frame.FrameIndex));

            Assert.Equal([.. Indices(60), .. Indices(60)], read);
        }

        using var player = RecordingPlayer.Open(Recording);
        player.Speed = RecordingPlayer.MaxSpeed;
        List<(int Sender, uint? Index)> played = [];
        await using var reader = new NeuronReader(player);
        reader.MotionReceived += frame => played.Add((frame.Sender, frame.FrameIndex));
        reader.Start();
        await reader.Completion.Soon();
        Assert.Equal([.. Indices(60), .. Indices(60)], played);
    }

    [Fact]
    public async Task The_last_frames_of_a_restarted_server_arrive()
    {
        await using UdpEnd end = await UdpEnd.StartAsync();
        await end.SendAsync(end.CreateSender(), TestPackets.Motion(1));
        await end.SendAsync(end.CreateSender(), TestPackets.Motion(2));
        await end.Reader.WaitForFramesAsync(2);
        Assert.Equal(0, Assert.Single(end.Reader.GetAvatarStatistics()).Sender);
    }

    // The first frame of a playback has its own time, not that of the frame that identified its sender. The second frame is delivered when the first
    // port has been silent for a quarter of a second. On a busy computer it may arrive later and then not wait; the test then tries again.
    [Fact]
    public async Task Delayed_frames_keep_their_arrival_time()
    {
        var patience = Stopwatch.StartNew();
        while (patience.Elapsed < Limits.Unexpected)
        {
            await using UdpEnd end = await UdpEnd.StartAsync();
            List<long> times = [];
            end.Reader.MotionReceived += frame => times.Add(frame.Timestamp);
            await end.SendAsync(end.CreateSender(), TestPackets.Motion(1));
            await Limits.UntilAsync(() => times.Count == 1);
            long sent = Stopwatch.GetTimestamp();
            await end.SendAsync(end.CreateSender(), TestPackets.Motion(2));
            await Limits.UntilAsync(() => times.Count == 2);
            Assert.True(Stopwatch.GetTimestamp() - times[0] >= Stopwatch.Frequency / 4);
            Assert.True(times[1] >= sent);
            if (times[1] - times[0] < Stopwatch.Frequency / 4)
                return;
        }

        Assert.Fail("Every frame has a time at which it was handed out.");
    }

    // A busy computer causes pauses, which the reader sees as a server's silence. The test then tries again.
    private static async Task WithoutPausesAsync(Func<UdpEnd, Pauses, Task> test)
    {
        var patience = Stopwatch.StartNew();
        while (patience.Elapsed < Limits.Unexpected)
        {
            await using UdpEnd end = await UdpEnd.StartAsync();
            var pauses = new Pauses(end.Reader);
            await test(end, pauses);
            if (!pauses.HasAny)
                return;
        }

        Assert.Fail("The machine makes pauses all the time.");
    }

    private static IEnumerable<(int Sender, uint? Index)> Indices(int count) => Enumerable.Range(0, count).Select(i => (0, (uint?)i));

    private static async Task SendAsync(UdpEnd end, Socket server, int frames)
    {
        for (int i = 0; i < frames; i++)
            await end.SendAsync(server, TestPackets.Motion(i));
    }

    // Whether servers that send in turn paused for more than an eighth of a second: half of the silence that counts for each of the two.
    private sealed class Pauses
    {
        private long _last;
        private volatile bool _hasAny;

        public Pauses(NeuronReader reader) => reader.MotionReceived += Check;

        public bool HasAny => _hasAny;

        private void Check(MotionFrame frame)
        {
            if (frame.FrameIndex >= ForgedFrame)
                return;

            if (_last != 0 && frame.Timestamp - _last > Stopwatch.Frequency / 8)
                _hasAny = true;

            _last = Math.Max(_last, frame.Timestamp);
        }
    }
}
