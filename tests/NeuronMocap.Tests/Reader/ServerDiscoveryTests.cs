using System.Collections.Concurrent;
using System.Diagnostics;
using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Reader;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Recording;

namespace NeuronMocap.Tests.Reader;

// What a reader requests on the command channel, how often, and who receives the answers.
public sealed class ServerDiscoveryTests : IDisposable
{
    private static readonly SkeletonFormat Format = new(RotationOrder.ZXY, SkeletonVariant.Spine3);
    private static readonly ChannelLayout Layout = new(hasDisplacement: false, hasReference: false);

    private readonly TestServer _server = new();
    private readonly RecordingFolder _folder = new();
    private readonly ConcurrentQueue<(CommandChannelId Id, int Avatar)> _asked = [];

    public void Dispose()
    {
        _server.Dispose();
        _folder.Dispose();
    }

    [Fact]
    public async Task Export_recording_and_program_share_a_connections_answers()
    {
        using CommandScript commands = Commands(_ => Tall(0.5f));
        await using var reader = new NeuronReader(Options(commands));
        string take = _folder.PathOf("take.nmrec");
        reader.StartRecording(take, new RecordingOptions { FlushInterval = TimeSpan.FromSeconds(0.01) });
        await using BvhExport export = reader.ExportBvh(_folder.PathOf("take.bvh"), new BvhExportOptions { HeaderTimeout = Limits.Unexpected });
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1, count: 180));

        SkeletonBody? body = null;
        await Limits.UntilAsync(() => reader.TryGetBody(0, out body));
        await Limits.UntilAsync(() => export.FramesWritten == 1);
        await Limits.UntilAsync(() =>
        {
            using RecordingReader growing = RecordingReader.Open(take);
            return growing.Metadata.BoneDimensions is not null;
        });

        Assert.Equal(Tall(0.5f).Offsets.ToArray(), body!.Offsets.ToArray());
        Assert.Equal(BvhBodyOrigin.Header, Assert.Single(export.Files).BodyOrigin);
        Assert.Equal(
            [(CommandChannelId.RotationOrder, -1), (CommandChannelId.BoneDimensions, 0), (CommandChannelId.BvhHeader, 0)],
            _asked.OrderBy(static question => question.Id));
    }

    [Fact]
    public async Task A_new_connection_requests_the_bodies_again()
    {
        float leg = 0.5f;
        using CommandScript commands = Commands(_ => Tall(Volatile.Read(ref leg)));
        await using var reader = new NeuronReader(Options(commands, reconnect: true));
        reader.Start();
        using (TestConnection first = await _server.AcceptAsync())
        {
            await Limits.UntilAsync(() => reader.TryGetBody(3, out SkeletonBody? body) && LegOf(body) == 50);

            // The reader connects and asks again as soon as this connection is closed.
            Volatile.Write(ref leg, 0.62f);
        }

        using TestConnection second = await _server.AcceptAsync();
        await Limits.UntilAsync(() =>
        {
            // It stays known in the meantime.
            Assert.True(reader.TryGetBody(3, out SkeletonBody? body));
            return LegOf(body) == 62;
        });
    }

    [Fact]
    public async Task Bone_sizes_make_the_body_without_a_header()
    {
        byte[] sizes = new byte[BoneDimensions.Size];
        Tall(0.5f).Measure().Write(sizes);
        using var commands = new CommandScript(request => request.ReplyAsync((CommandChannelId)request.Id is CommandChannelId.BoneDimensions ? sizes : [0, 0, 0, 0]));
        await using var reader = new NeuronReader(Options(commands));
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();

        SkeletonBody? body = null;
        await Limits.UntilAsync(() => reader.TryGetBody(1, out body));
        Assert.Equal((50, SkeletonVariant.Neck1), (LegOf(body!), body!.Variant));
        Assert.True(reader.TryGetBody(1, out SkeletonBody? again));
        Assert.Same(body, again);
    }

    [Fact]
    public void There_is_no_body_without_a_command_port()
    {
        using var reader = new NeuronReader(_server.Options());
        Assert.False(reader.TryGetBody(0, out SkeletonBody? body));
        Assert.Null(body);
    }

    [Fact]
    public async Task Requests_for_forged_avatars_are_limited()
    {
        using CommandScript commands = Commands(_ => Tall(0.5f));
        using ServerDiscovery discovery = Create(commands);
        for (int avatar = -10; avatar < 1000; avatar++)
            Assert.Null(discovery.FindBody(avatar));

        discovery.Begin();
        await Limits.UntilAsync(() => discovery.FindBody(255) is not null);
        Assert.Equal(Enumerable.Range(0, 256), _asked.Where(static question => question.Id == CommandChannelId.BvhHeader).Select(static question => question.Avatar).Order());
    }

    [Fact]
    public async Task A_known_body_allocates_nothing()
    {
        using CommandScript commands = Commands(_ => Tall(0.5f));
        using ServerDiscovery discovery = Create(commands);
        discovery.FindBody(0);
        discovery.Begin();
        await Limits.UntilAsync(() => discovery.FindBody(0) is not null);
        Allocations.AssertNone(() => discovery.FindBody(0));
    }

    [Fact]
    public async Task A_failing_server_is_asked_less_and_less_often()
    {
        int requests = 0;
        using var commands = new CommandScript(request =>
        {
            Interlocked.Increment(ref requests);
            return request.ReplyAsync([9, 0, 0, 0]);
        });
        int rounds = 0;
        using ServerDiscovery discovery = Create(commands, () => Interlocked.Increment(ref rounds));

        // Before the newest failure, so that a pause of this thread makes no round due.
        long begun = Stopwatch.GetTimestamp();
        discovery.Begin();
        await RoundsAsync(1);
        foreach (int seconds in new[] { 5, 10, 20 })
            await RetryAsync(seconds);

        // A new connection starts again.
        begun = Stopwatch.GetTimestamp();
        discovery.Begin();
        await RoundsAsync(5);
        await RetryAsync(5);

        async Task RetryAsync(int seconds)
        {
            int before = Volatile.Read(ref rounds);
            discovery.Check(begun + ((seconds - 1) * Stopwatch.Frequency));
            Assert.Equal(before, Volatile.Read(ref requests));
            begun = Stopwatch.GetTimestamp();
            await Limits.UntilAsync(() =>
            {
                discovery.Check(Stopwatch.GetTimestamp() + ((seconds + 1) * Stopwatch.Frequency));
                return Volatile.Read(ref rounds) > before;
            });
        }

        Task RoundsAsync(int count) => Limits.UntilAsync(() => Volatile.Read(ref rounds) == count);
    }

    [Fact]
    public async Task A_new_avatar_asks_a_silent_server_once()
    {
        int requests = 0;
        using var commands = new CommandScript(request =>
        {
            Interlocked.Increment(ref requests);
            request.Connection.Close();
            return Task.CompletedTask;
        });
        int rounds = 0;
        using ServerDiscovery discovery = Create(commands, () => Interlocked.Increment(ref rounds));

        discovery.Begin();
        await Limits.UntilAsync(() => Volatile.Read(ref rounds) == 1);
        Assert.Null(discovery.FindBody(0));
        await Limits.UntilAsync(() =>
        {
            discovery.Check(Stopwatch.GetTimestamp());
            return Volatile.Read(ref rounds) == 2;
        });

        // That was the format again, and the body's header follows. If the first round had not ended, it asked for the header too.
        // The next round is the one that is due.
        for (int i = 0; i < 100; i++)
            discovery.Check(Stopwatch.GetTimestamp());

        await Limits.UntilAsync(() =>
        {
            discovery.Check(Stopwatch.GetTimestamp() + (6 * Stopwatch.Frequency));
            return Volatile.Read(ref rounds) >= 3 && Volatile.Read(ref requests) >= 5;
        });
        Assert.Equal(3, Volatile.Read(ref rounds));
        Assert.InRange(Volatile.Read(ref requests), 5, 6);
    }

    private static SkeletonBody Tall(float upperLeg) =>
        SkeletonBody.FromDimensions(SkeletonBody.GetDefault().Measure() with { UpperLeg = upperLeg }, Format.Variant);

    // In centimetres.
    private static int LegOf(SkeletonBody body) => (int)MathF.Round(body.GetOffset(Bone.LeftLeg).Length());

    private static ServerDiscovery Create(CommandScript commands, Action? learnt = null) =>
        new(new NeuronCommandOptions { Port = commands.Port, Timeout = Limits.Unexpected }, new FrameFormat(order: null, variant: null), learnt ?? (static () => { }));

    private CommandScript Commands(Func<int, SkeletonBody> body) => new(request =>
    {
        var id = (CommandChannelId)request.Id;
        int avatar = request.Payload.Length > 0 ? request.Avatar : -1;
        _asked.Enqueue((id, avatar));
        if (id == CommandChannelId.RotationOrder)
            return request.ReplyAsync([(byte)Format.RotationOrder, 0, 0, 0]);
        if (id == CommandChannelId.BvhHeader)
            return request.ReplyAsync(Encoding.ASCII.GetBytes(BvhHierarchyText.Create(BvhBoneHierarchy.Create(Format, Layout, body(avatar)))));

        byte[] sizes = new byte[BoneDimensions.Size];
        body(avatar).Measure().Write(sizes);
        return request.ReplyAsync(sizes);
    });

    private NeuronReaderOptions Options(CommandScript commands, bool reconnect = false)
    {
        NeuronReaderOptions options = _server.Options(reconnect);
        options.CommandPort = commands.Port;
        return options;
    }
}
