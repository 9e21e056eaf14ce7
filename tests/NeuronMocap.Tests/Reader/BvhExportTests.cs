using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Bvh;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server.Sources;

namespace NeuronMocap.Tests.Reader;

public sealed class BvhExportTests : BvhExportTest
{
    [Fact]
    public async Task A_broadcast_take_is_exported_bit_for_bit()
    {
        BvhDocument take = BvhDocument.Parse(NeuronTake.Write(600));
        await using var broadcaster = new Broadcaster(new BroadcasterOptions
        {
            Sources = [new BvhSource(take)],
            Port = 0,
            FrameRate = BroadcasterOptions.MaxFrameRate,
            WaitForClient = true,
        });
        broadcaster.Start();
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = broadcaster.LocalEndPoint!.Port, Reconnect = { Enabled = false } });
        using BvhExport export = reader.ExportBvh(Target, new BvhExportOptions { FrameTime = take.FrameTime });
        reader.Start();
        await export.Completion.Soon();

        Assert.Null(export.Failure);
        Assert.Equal(0, export.FramesDropped);
        BvhExportFile file = Assert.Single(export.Files);
        Assert.Equal((Target, 600, 0, 0), (file.Path, file.FrameCount, file.RepeatedFrames, file.LateFrames));
        BvhDocument read = BvhDocument.Load(Target);
        Assert.Empty(read.Repairs);
        BvhSamples.AssertBits(BvhSamples.Values(take), BvhSamples.Values(read));
    }

    [Theory]
    [InlineData("text")]
    [InlineData("studio")]
    [InlineData("old")]
    public async Task Frames_of_every_format_are_exported(string format)
    {
        byte[][] packets = [.. Enumerable.Range(0, 3).Select(frame => format switch
        {
            "text" => TestPackets.Line(frame),
            "old" => TestPackets.Motion(frame, layout: HeaderLayout.Old),
            _ => StudioMotion(frame),
        })];
        BvhExport export = await ExportAsync(packets);

        Assert.Null(export.Failure);
        BvhDocument read = BvhDocument.Load(Target);
        Assert.Equal(3, read.FrameCount);
        Assert.Equal(TestPackets.Value(2, 0, 353), read.GetValues(2)[353]);
        Assert.Equal(format is "studio" ? "Zrotation Xrotation Yrotation" : "Yrotation Xrotation Zrotation", string.Join(' ', read.Joints[0].Channels.Skip(3)));
        Assert.Equal(BvhBodyOrigin.Stream, export.Files[0].BodyOrigin);
    }

    [Fact]
    public async Task Only_the_first_avatar_is_exported_by_default()
    {
        byte[][] packets = [TestPackets.Motion(0, 3), TestPackets.Motion(0, 1), TestPackets.Motion(1, 3), TestPackets.Motion(1, 3, count: 17), TestPackets.Calculation(1, 3)];
        BvhExport export = await ExportAsync(packets);
        Assert.Equal((2, 2), (export.FramesWritten, export.FramesIgnored));
        Assert.Equal(3, Assert.Single(export.Files).AvatarIndex);

        export = await ExportAsync(packets, new BvhExportOptions { AvatarIndex = 1, Overwrite = true });
        Assert.Equal((1, 3), (export.FramesWritten, export.FramesIgnored));
        Assert.Equal(TestPackets.Value(0, 1, 5), BvhDocument.Load(Target).GetValues(0)[5]);
    }

    [Fact]
    public async Task Every_avatar_gets_a_file_when_asked_for()
    {
        BvhExport export = await ExportAsync(
            [TestPackets.Motion(0, 3), TestPackets.Motion(0, 1), TestPackets.Motion(1, 3)], new BvhExportOptions { FilePerAvatar = true });

        Assert.Equal(["take-avatar1.bvh", "take-avatar3.bvh"], Folder.GetFiles().Select(static file => file.Name).Order(StringComparer.Ordinal));
        Assert.Equal([2, 1], export.Files.Select(static file => file.FrameCount));
        Assert.Equal(TestPackets.Value(1, 3, 5), BvhDocument.Load(export.Files[0].Path).GetValues(1)[5]);
    }

    [Fact]
    public async Task A_changed_layout_begins_another_file()
    {
        BvhExport export = await ExportAsync([TestPackets.Motion(0), TestPackets.Motion(1, count: 180), TestPackets.Motion(2, count: 180), TestPackets.Motion(3)]);

        Assert.Equal(["take-part2.bvh", "take-part3.bvh", "take.bvh"], Folder.GetFiles().Select(static file => file.Name).Order(StringComparer.Ordinal));
        Assert.Equal([1, 2, 1], export.Files.Select(static file => file.FrameCount));
        Assert.Equal(180, BvhDocument.Load(export.Files[1].Path).ChannelCount);
        Assert.Equal([BvhBodyOrigin.Stream, BvhBodyOrigin.Default, BvhBodyOrigin.Stream], export.Files.Select(static file => file.BodyOrigin));
    }

    [Fact]
    public async Task Endless_layout_changes_end_the_export_but_not_the_reader()
    {
        byte[][] packets = [.. Enumerable.Range(0, 120).Select(static frame => TestPackets.Motion(frame, count: frame % 2 == 0 ? 180 : 354))];
        BvhExport export = await ExportAsync(packets);

        Assert.Contains("changed the layout", Assert.IsType<NeuronException>(export.Failure).Message, StringComparison.Ordinal);
        Assert.Equal(100, Folder.GetFiles().Length);
    }

    [Fact]
    public async Task Hierarchy_and_rotation_order_come_from_the_command_channel()
    {
        var told = new SkeletonFormat(RotationOrder.ZXY, SkeletonVariant.Spine3);
        var body = SkeletonBody.FromDimensions(SkeletonBody.GetDefault().Measure() with { UpperLeg = 0.5f }, SkeletonVariant.Spine3);
        using var commands = new CommandScript(request => request.ReplyAsync(request.Id == 1003
            ? [(byte)told.RotationOrder, 0, 0, 0]
            : Encoding.ASCII.GetBytes(BvhHierarchyText.Create(BvhBoneHierarchy.Create(told, default, body)))));
        BvhExport export = await ExportAsync([TestPackets.Motion(0, count: 180), TestPackets.Motion(1, count: 180)], Patient, commands.Port);

        BvhDocument read = BvhDocument.Load(Target);
        Assert.Equal(BvhBodyOrigin.Header, Assert.Single(export.Files).BodyOrigin);
        Assert.Equal(2, read.FrameCount);
        Assert.Equal(body.Offsets.ToArray(), read.Joints.Select(static joint => joint.Offset));
        Assert.Equal("Zrotation Xrotation Yrotation", string.Join(' ', read.Joints[5].Channels));
        Assert.Contains(read.Joints, static joint => joint.Name is "Spine3");
    }

    [Fact]
    public async Task Bone_sizes_replace_a_missing_header()
    {
        BoneDimensions dimensions = SkeletonBody.GetDefault().Measure() with { UpperLeg = 0.5f };
        byte[] sizes = new byte[BoneDimensions.Size];
        dimensions.Write(sizes);
        using var commands = new CommandScript(request => request.ReplyAsync(request.Id switch
        {
            1003 => [(byte)RotationOrder.YXZ, 0, 0, 0],
            1004 => sizes,
            _ => "no header"u8.ToArray(),
        }));
        BvhExport export = await ExportAsync([TestPackets.Motion(0, count: 180)], Patient, commands.Port);

        Assert.Equal(BvhBodyOrigin.Dimensions, Assert.Single(export.Files).BodyOrigin);
        Assert.Equal(-50, BvhDocument.Load(Target).Joints[2].Offset.Y, 1e-3);
    }

    [Fact]
    public async Task A_silent_command_channel_delays_the_export_up_to_a_limit()
    {
        using var commands = new CommandScript(static _ => Task.CompletedTask);
        BvhExport export = await ExportAsync(
            [TestPackets.Motion(0, count: 180)], new BvhExportOptions { HeaderTimeout = TimeSpan.FromMilliseconds(20) }, commands.Port);

        Assert.Equal(BvhBodyOrigin.Default, Assert.Single(export.Files).BodyOrigin);
        Assert.Equal(1, BvhDocument.Load(Target).FrameCount);
    }

    [Fact]
    public async Task The_frame_limit_ends_the_export()
    {
        BvhExport export = await ExportAsync([TestPackets.Motions(0, 300)], new BvhExportOptions { MaxFrames = 257 });
        Assert.Equal(257, export.FramesWritten);
        Assert.Equal(257, BvhDocument.Load(Target).FrameCount);
    }

    // The writer waits for the command channel. A disk that does not answer has the same effect.
    [Fact]
    public async Task A_full_export_queue_drops_and_counts_without_blocking()
    {
        using var commands = new CommandScript(static _ => Task.CompletedTask);
        NeuronReaderOptions options = Server.Options();
        options.CommandPort = commands.Port;
        await using var reader = new NeuronReader(options);
        using BvhExport export = reader.ExportBvh(Target, new BvhExportOptions { HeaderTimeout = Limits.Unexpected, Capacity = 4 });
        reader.Start();
        using TestConnection connection = await Server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 100));

        // Consumers receive a packet one after the other, and the export after the consumers that report it. Only now has it received the hundredth.
        await Limits.UntilAsync(() => export.FramesDropped == 96);
        await reader.WaitForFramesAsync(100);

        // The writer waits no longer for an answer.
        commands.Dispose();
        await export.StopAsync(TestContext.Current.CancellationToken).Soon();
        Assert.Null(export.Failure);
        Assert.Equal(4, BvhDocument.Load(Target).FrameCount);
        Assert.False(reader.Completion.IsCompleted);
    }

    [Fact]
    public async Task Start_and_end_of_an_export_are_reported()
    {
        var events = new System.Collections.Concurrent.ConcurrentQueue<ReaderEvent>();
        var reader = new NeuronReader(Server.Options());
        reader.EventReported += events.Enqueue;
        BvhExport export = reader.ExportBvh(Target);
        reader.Start();
        using TestConnection connection = await Server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 3));
        await Limits.UntilAsync(() => export.FramesWritten == 3);
        await reader.DisposeAsync();

        // The reader also ends its exports.
        await export.StopAsync(TestContext.Current.CancellationToken).Soon();
        Assert.Equal(
            [ReaderEventId.ExportStarted, ReaderEventId.ExportStopped],
            events.Select(static news => news.Id).Where(static id => id >= ReaderEventId.ExportStarted));
        Assert.Contains(events, static news => news.Id == ReaderEventId.ExportStopped && news.Message.StartsWith("Exported 3 frames to ", StringComparison.Ordinal));
    }

    [Fact]
    public async Task An_export_may_start_and_end_while_the_reader_runs()
    {
        await using var reader = new NeuronReader(Server.Options());
        reader.Start();
        using TestConnection connection = await Server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 3));
        await reader.WaitForFramesAsync(3);
        BvhExport export = reader.ExportBvh(Target);
        await connection.SendAsync(TestPackets.Motions(3, 4));
        await Limits.UntilAsync(() => export.FramesWritten == 4);
        export.Dispose();
        export.Dispose();
        await connection.SendAsync(TestPackets.Motions(7, 2));
        await reader.WaitForFramesAsync(9);

        BvhDocument take = BvhDocument.Load(Target);
        Assert.Equal([3f, 4, 5, 6], Enumerable.Range(0, take.FrameCount).Select(frame => take.GetValues(frame)[0]));
        Assert.Equal(4, export.FramesWritten);
    }

    private static byte[] StudioMotion(int frame)
    {
        byte[] packet = TestPackets.Motion(frame);
        DataVersion.Studio.Write(packet.AsSpan(2));
        packet[50] = (byte)RotationOrder.ZXY;
        return packet;
    }
}
