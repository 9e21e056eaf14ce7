using System.Diagnostics;
using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Frames;
using NeuronMocap.Reader;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// Information missing from the stream, requested on the command channel.
public sealed class FormatDiscoveryTests : IDisposable
{
    private static readonly SkeletonFormat Told = new(RotationOrder.ZXY, SkeletonVariant.Spine3);

    private readonly TestServer _server = new();

    public void Dispose() => _server.Dispose();

    [Fact]
    public async Task The_command_channel_sets_the_format_and_the_status_shows_it()
    {
        using CommandScript commands = Commands(Told);
        (MotionFrame frame, ConnectionStatus status) = await ReceiveAsync(
            Options(commands), sent => sent.Format == Told, told => told.Message.Contains("Spine3", StringComparison.Ordinal));

        Assert.Equal(EulerAngles.ToQuaternion(frame.GetEulerAngles(Bone.Head), RotationOrder.ZXY), frame.GetRotation(Bone.Head));
        Assert.Contains("rotation order ZXY, as the command channel says; bones with Spine3, as the command channel says", status.Message, StringComparison.Ordinal);
        Assert.Equal(ConnectionReason.None, status.Reason);
    }

    [Fact]
    public async Task The_options_win_over_the_command_channel_with_a_warning()
    {
        using CommandScript commands = Commands(Told);
        NeuronReaderOptions options = Options(commands);
        options.RotationOrder = RotationOrder.XYZ;
        (MotionFrame frame, ConnectionStatus status) = await ReceiveAsync(
            options, sent => sent.Format.Variant == SkeletonVariant.Spine3, told => told.Reason == ConnectionReason.RotationOrderMismatch);

        Assert.Equal(RotationOrder.XYZ, frame.Format.RotationOrder);
        Assert.Contains("XYZ", status.Message, StringComparison.Ordinal);
        Assert.Contains("the command channel says ZXY", status.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_variant_other_than_the_option_is_reported()
    {
        using CommandScript commands = Commands(Told);
        NeuronReaderOptions options = Options(commands);
        options.SkeletonVariant = SkeletonVariant.Neck1;
        (MotionFrame frame, ConnectionStatus status) = await ReceiveAsync(
            options, sent => sent.Format.RotationOrder == RotationOrder.ZXY, told => told.Reason == ConnectionReason.SkeletonVariantMismatch);

        Assert.Equal(SkeletonVariant.Neck1, frame.Format.Variant);
        Assert.Contains("Spine3", status.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_silent_command_channel_is_reported_while_frames_arrive()
    {
        using var nobody = new TestServer();
        int port = nobody.Port;
        nobody.Dispose();
        NeuronReaderOptions options = _server.Options();
        options.CommandPort = port;
        (MotionFrame frame, ConnectionStatus status) = await ReceiveAsync(options, _ => true, told => told.Reason == ConnectionReason.NotDiscovered);

        Assert.Equal(SkeletonFormat.Default, frame.Format);
        Assert.Contains("YXZ assumed", status.Message, StringComparison.Ordinal);
        Assert.Contains("refused the connection", status.Message, StringComparison.Ordinal);
        Assert.Contains("CommandPort", status.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_header_of_another_skeleton_is_reported()
    {
        const string Other = "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 3 Yrotation Xrotation Zrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n";
        using var commands = new CommandScript(request => request.ReplyAsync(request.Id == 1003 ? [2, 0, 0, 0] : Encoding.ASCII.GetBytes(Other)));
        (MotionFrame frame, ConnectionStatus status) = await ReceiveAsync(
            Options(commands), sent => sent.Format.RotationOrder == RotationOrder.XYZ, told => told.Reason == ConnectionReason.NotDiscovered);

        Assert.Equal(SkeletonVariant.Neck1, frame.Format.Variant);
        Assert.Contains("rotation order XYZ, as the command channel says", status.Message, StringComparison.Ordinal);
        Assert.Contains("another skeleton", status.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Every_new_connection_asks_again()
    {
        SkeletonFormat told = Told;
        using var commands = new CommandScript(request => AnswerAsync(request, told));
        await using var reader = new NeuronReader(Options(commands, reconnect: true));
        using LatestFrames latest = reader.OpenLatest();
        reader.Start();
        using (TestConnection first = await _server.AcceptAsync())
        {
            await SendUntilAsync(first, latest, sent => sent.Format == Told);

            // The reader connects and asks again as soon as this connection is closed.
            told = new SkeletonFormat(RotationOrder.XZY, SkeletonVariant.Neck1);
        }

        using TestConnection second = await _server.AcceptAsync();
        await SendUntilAsync(second, latest, sent => sent.Format == told);
    }

    [Fact]
    public async Task Unanswered_requests_are_repeated_on_the_connection()
    {
        int requests = 0;
        using var commands = new CommandScript(request => Interlocked.Increment(ref requests) == 1 ? request.ReplyAsync([9, 0, 0, 0]) : AnswerAsync(request, Told));
        var format = new FrameFormat(order: null, variant: null);
        using var discovery = new ServerDiscovery(new() { Port = commands.Port }, format, learnt: () => { });

        discovery.Begin();
        await Limits.UntilAsync(() => format.Discovered.Failure is not null);
        discovery.Check(Stopwatch.GetTimestamp());
        Assert.Equal(1, Volatile.Read(ref requests));

        await Limits.UntilAsync(() =>
        {
            discovery.Check(Stopwatch.GetTimestamp() + (6 * Stopwatch.Frequency));
            return format.Discovered is { Failure: null, Variant: not null };
        });
        Assert.Equal(new DiscoveredFormat(Told.RotationOrder, Told.Variant, null), format.Discovered);
    }

    [Fact]
    public async Task An_unexpected_exception_is_reported_and_the_request_repeated()
    {
        using CommandScript commands = Commands(Told);
        int calls = 0;
        var format = new FrameFormat(order: null, variant: null);
        using var discovery = new ServerDiscovery(
            new() { Port = commands.Port },
            format,
            learnt: () =>
            {
                if (Interlocked.Increment(ref calls) == 1)
                    throw new InvalidOperationException("out of order");
            });

        discovery.Begin();
        await Limits.UntilAsync(() => format.Discovered.Failure?.Contains("out of order", StringComparison.Ordinal) == true);
        await Limits.UntilAsync(() =>
        {
            discovery.Check(Stopwatch.GetTimestamp() + (6 * Stopwatch.Frequency));
            return format.Discovered is { Failure: null, Variant: not null };
        });
    }

    [Fact]
    public void Data_and_command_port_must_differ()
    {
        ArgumentException exception = Assert.Throws<ArgumentException>(() => new NeuronReader(new NeuronReaderOptions { Port = 7001, CommandPort = 7001 }));
        Assert.Contains("CommandPort and Port are both 7001", exception.Message, StringComparison.Ordinal);
        new NeuronReader(new NeuronReaderOptions { Transport = TransportKind.Udp, Port = 7001, CommandPort = 7001 }).Dispose();
    }

    [Fact]
    public async Task A_reader_waiting_for_an_answer_stops_at_once()
    {
        var asked = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        using var commands = new CommandScript(_ =>
        {
            asked.TrySetResult();
            return Task.CompletedTask;
        });
        var reader = new NeuronReader(Options(commands));
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        await asked.Task.Soon();

        await reader.DisposeAsync().AsTask().Soon();
        await reader.Completion.Soon();
    }

    internal static CommandScript Commands(SkeletonFormat told) => new(request => AnswerAsync(request, told));

    private static Task AnswerAsync(ScriptedRequest request, SkeletonFormat told) => request.ReplyAsync(request.Id == 1003
        ? [(byte)told.RotationOrder, 0, 0, 0]
        : Encoding.ASCII.GetBytes(BvhHierarchyText.Create(told, new ChannelLayout(hasDisplacement: true, hasReference: false))));

    private NeuronReaderOptions Options(CommandScript commands, bool reconnect = false)
    {
        NeuronReaderOptions options = _server.Options(reconnect);
        options.CommandPort = commands.Port;
        return options;
    }

    // Returns the first wanted frame and the first wanted status of a reader that receives from one connection.
    private async Task<(MotionFrame Frame, ConnectionStatus Status)> ReceiveAsync(
        NeuronReaderOptions options, Predicate<MotionFrame> wanted, Predicate<ConnectionStatus> told)
    {
        await using var reader = new NeuronReader(options);
        var log = new StatusLog(reader);
        using LatestFrames latest = reader.OpenLatest();
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        MotionFrame frame = await SendUntilAsync(connection, latest, wanted);
        return (frame.Clone(), await log.WaitAsync(told));
    }

    private static async Task<MotionFrame> SendUntilAsync(TestConnection connection, LatestFrames latest, Predicate<MotionFrame> wanted)
    {
        MotionFrame? found = null;
        int number = 0;
        while (found is null)
        {
            await connection.SendAsync(TestPackets.Motion(++number));
            await Limits.UntilAsync(() => latest.TryTakeMotion(0, out _));
            latest.TryTakeMotion(0, out MotionFrame? frame);
            found = wanted(frame!) ? frame : null;
        }

        return found;
    }
}
