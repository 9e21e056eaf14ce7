using NeuronMocap.Tests.Network;

namespace NeuronMocap.Server.Tests.Osc;

// Senders between a reader with a real connection and real ports.
public sealed class PoseSenderTests
{
    [Fact]
    public async Task Two_performers_go_to_two_ports()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        using var annsModel = new PoseReceiver();
        using var bobsModel = new PoseReceiver();
        await using var ann = new VmcSender(reader, new VmcSenderOptions { Port = annsModel.Port, AvatarName = "Ann", MaxRate = 0 });
        await using var bob = new VmcSender(reader, new VmcSenderOptions { Port = bobsModel.Port, AvatarIndex = 1, MaxRate = 0 });
        ann.Start();
        bob.Start();
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        for (int i = 1; i < 20; i++)
        {
            MotionFrame annsPose = Poses.Frame(i);
            MotionFrame bobsPose = Poses.Frame(100 + i, avatar: 1, name: "Bob");
            await source.SendAsync((byte[])[.. annsPose.Packet, .. bobsPose.Packet]);
            (await annsModel.ReceiveModelAsync()).AssertShows(annsPose, tolerance: 2e-4f);
            (await bobsModel.ReceiveModelAsync()).AssertShows(bobsPose, tolerance: 2e-4f);
        }

        source.Close();
        await Task.WhenAll(ann.Completion, bob.Completion).Soon();
        foreach (PoseSender sender in (PoseSender[])[ann, bob])
        {
            PoseSenderStatistics statistics = sender.GetStatistics();
            Assert.Equal((19, 0, 19, 19 * 4), (statistics.FramesSent, statistics.FramesDropped, statistics.FramesIgnored, statistics.DatagramsSent));
            Assert.Null(statistics.Failure);
        }

        Assert.Equal((0, 0), (annsModel.Available, bobsModel.Available));
    }

    [Fact]
    public async Task All_avatars_go_to_plain_osc()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        using var receiver = new PoseReceiver();
        await using var sender = new OscSender(reader, new OscSenderOptions { Port = receiver.Port, Prefix = "/stage/left", MaxDatagramSize = 65_507 });
        sender.Start();
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        await source.SendAsync((byte[])[.. Poses.Frame(1).Packet, .. Poses.Frame(1, 1, "Bob").Packet]);
        List<OscMessage> messages = [.. await receiver.ReceiveFrameAsync(), .. await receiver.ReceiveFrameAsync()];
        Assert.Equal(2 * 60, messages.Count);
        Assert.Equal(60, messages.Count(static message => message.Address.StartsWith("/stage/left/Bob/", StringComparison.Ordinal)));
    }

    [Fact]
    public async Task Every_frame_is_sent_dropped_or_ignored()
    {
        const int Count = 2400;
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        using var receiver = new PoseReceiver();
        await using var sender = new OscSender(reader, new OscSenderOptions { Port = receiver.Port, MaxRate = 0, AvatarIndex = 0 });
        sender.Start();
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        byte[][] packets = [TestPackets.Motion(0), TestPackets.Motion(0, avatar: 1), TestPackets.Motion(0, count: 7), TestPackets.Calculation(0)];
        for (int i = 0; i < Count; i += 40)
            await source.SendAsync(TestPackets.Join(Enumerable.Range(i, 40).Select(index => packets[index % 4])));

        source.Close();
        await sender.Completion.Soon();
        PoseSenderStatistics statistics = sender.GetStatistics();
        Assert.Equal(3 * Count / 4, statistics.FramesSent + statistics.FramesDropped + statistics.FramesIgnored);
        Assert.InRange(statistics.FramesSent, 1, Count / 4);
        Assert.Equal(0, statistics.DatagramsFailed);
    }

    [Fact]
    public async Task A_rate_leaves_frames_out()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        using var receiver = new PoseReceiver();
        await using var sender = new VmcSender(reader, new VmcSenderOptions { Port = receiver.Port, MaxRate = 0.01 });
        sender.Start();
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        await source.SendAsync(TestPackets.Join(Enumerable.Range(0, 50).Select(static index => Poses.Frame(index).Packet.ToArray())));
        source.Close();
        await sender.Completion.Soon();
        Assert.Equal((1, 49), (sender.GetStatistics().FramesSent, sender.GetStatistics().FramesSkipped));
    }

    [Fact]
    public async Task A_receiver_that_is_off_ends_nothing()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await using var sender = new VmcSender(reader, new VmcSenderOptions { Port = FreePort.Next(), MaxRate = 0 });
        sender.Start();
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        long sent = 0;
        for (int i = 0; i < 100; i++)
        {
            await source.SendAsync(Poses.Frame(i).Packet.ToArray());
            await Limits.UntilAsync(() => sender.GetStatistics().FramesSent > sent);
            sent = sender.GetStatistics().FramesSent;
        }

        Assert.False(sender.Completion.IsCompleted);
        Assert.Equal((0, null), (sender.GetStatistics().DatagramsFailed, sender.GetStatistics().Failure));
        if (OperatingSystem.IsLinux())
            Assert.True(sender.GetStatistics().Refusals > 0);
    }

    [Fact]
    public async Task A_name_without_an_address_drops_frames_and_says_so()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await using var sender = new VmcSender(reader, new VmcSenderOptions { Host = "a..b", MaxRate = 0 });
        sender.Start();
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        long i = 0;
        await Limits.UntilAsync(() =>
        {
            source.Socket.Send(Poses.Frame((int)++i).Packet);
            return sender.GetStatistics().Failure is not null;
        });
        Assert.StartsWith("the host name a..b has no address (", sender.GetStatistics().Failure, StringComparison.Ordinal);
        source.Close();
        await sender.Completion.Soon();
        Assert.Equal((0, i), (sender.GetStatistics().FramesSent, sender.GetStatistics().FramesDropped));
    }

    [Fact]
    public async Task It_ends_with_the_reader_or_when_it_is_disposed_in_any_order()
    {
        await using (var reader = new NeuronReader(new MemoryStream()))
        {
            var never = new VmcSender(reader);
            never.Dispose();
            never.Dispose();
            await never.DisposeAsync().AsTask().Soon();
            await never.Completion.Soon();
            Assert.Throws<ObjectDisposedException>(never.Start);

            var disposed = new VmcSender(reader);
            disposed.Start();
            Assert.Throws<InvalidOperationException>(disposed.Start);
            await disposed.DisposeAsync().AsTask().Soon();
            Assert.True(disposed.Completion.IsCompletedSuccessfully);

            await using var ended = new OscSender(reader);
            ended.Start();
            reader.Start();
            await ended.Completion.Soon();
        }
    }

    [Fact]
    public async Task Settings_out_of_range_are_named()
    {
        await using var reader = new NeuronReader(new MemoryStream());
        VmcSenderOptions[] wrong =
        [
            new() { Host = " " }, new() { Host = "[::1]:39539" }, new() { Host = "studio:39539" }, new() { Port = 0 }, new() { Port = 65_536 }, new() { MaxRate = -1 }, new() { MaxRate = 1001 }, new() { MaxRate = double.NaN },
            new() { Scale = 0 }, new() { Scale = float.NaN }, new() { Scale = float.PositiveInfinity }, new() { MaxDatagramSize = 511 }, new() { MaxDatagramSize = 65_508 },
        ];
        Assert.All(wrong, options =>
            Assert.StartsWith($"{nameof(VmcSenderOptions)}.", Assert.Throws<ArgumentException>(() => new VmcSender(reader, options)).Message, StringComparison.Ordinal));

        foreach (string prefix in (string[])["", "/", "neuron", "/a/", "/a b", "/a*", "/é", "/" + new string('a', 64)])
            Assert.Equal("Prefix", Assert.Throws<ArgumentException>(() => new OscSender(reader, new OscSenderOptions { Prefix = prefix })).ParamName);
        Assert.Equal("Prefix", Assert.Throws<ArgumentException>(() => new OscSender(reader, new OscSenderOptions { Prefix = null! })).ParamName);
        Assert.Equal("Space", Assert.Throws<ArgumentException>(() => new OscSender(reader, new OscSenderOptions { Space = (OscSpace)2 })).ParamName);
        Assert.Throws<ArgumentNullException>(() => new VmcSender(null!));
        Assert.Throws<ArgumentNullException>(() => new OscSender(null!));
    }
}
