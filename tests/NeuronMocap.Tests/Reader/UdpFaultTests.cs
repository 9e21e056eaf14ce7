using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// The effects of networks on datagrams, and the resulting counters.
public sealed class UdpFaultTests
{
    // A datagram is written as its frame number. The suffix a stands for its first 1024 bytes, b for the rest, no suffix for all of it.
    [Theory]
    [InlineData("0 2 1 3", "0 2 1 3", 0, 0, 1)]
    [InlineData("0 0 1 1 2", "0 0 1 1 2", 0, 0, 2)]
    [InlineData("0 1 5 6", "0 1 5 6", 0, 3, 0)]
    [InlineData("0a 0b 1a 1b", "0 1", 0, 0, 0)]
    [InlineData("0a 0b 1a 2a 2b", "0 2", 1024, 1, 0)]
    [InlineData("0a 0b 1b 2a 2b", "0 2", 456, 1, 0)]
    [InlineData("0a 0a 0b 1a 1b", "0 1", 1024, 0, 0)]
    [InlineData("0a 0b 0b 1a 1b", "0 1", 456, 0, 0)]
    [InlineData("0a 0b 1b 1a 2a 2b", "0 2", 1480, 1, 0)]
    [InlineData("0a 0b 1a 2 3", "0 2 3", 1024, 1, 0)]
    public async Task Swapped_doubled_and_lost_datagrams_are_counted(string sent, string delivered, long skipped, long lost, long disordered)
    {
        await using UdpEnd end = await UdpEnd.StartAsync();
        List<uint?> indices = [];
        end.Reader.MotionReceived += frame => indices.Add(frame.FrameIndex);
        Socket sender = end.CreateSender();
        foreach (string datagram in sent.Split(' '))
            await end.SendAsync(sender, Datagram(datagram));

        uint?[] expected = [.. delivered.Split(' ').Select(index => (uint?)uint.Parse(index, provider: null))];
        await end.Reader.UntilAsync(statistics => statistics.BytesReceived == (expected.Length * 1480) + skipped);

        Assert.Equal(expected, indices);
        Assert.Equal((skipped, lost), (end.Reader.GetStatistics().BytesSkipped, end.Reader.GetStatistics().Lost));
        Assert.Equal(disordered, Assert.Single(end.Reader.GetAvatarStatistics()).OutOfOrder);
    }

    [Fact]
    public async Task Two_senders_whose_halves_interleave_lose_nothing()
    {
        await using UdpEnd end = await UdpEnd.StartAsync();
        Socket one = end.CreateSender();
        Socket two = end.CreateSender();
        for (int i = 0; i < 100; i++)
        {
            byte[] first = TestPackets.Motion(i);
            byte[] second = TestPackets.Motion(i + 5000);
            await end.SendAsync(one, first.AsMemory(0, 1024));
            await end.SendAsync(two, second.AsMemory(0, 1024));
            await end.SendAsync(one, first.AsMemory(1024));
            await end.SendAsync(two, second.AsMemory(1024));
        }

        await end.Reader.WaitForFramesAsync(200);
        Assert.Equal((0L, 0L), (end.Reader.GetStatistics().BytesSkipped, end.Reader.GetStatistics().Lost));
        Assert.All(end.Reader.GetAvatarStatistics(), avatar => Assert.Equal((100L, 0L), (avatar.Frames, avatar.OutOfOrder)));
    }

    [Fact]
    public async Task Many_alternating_senders_are_distinguished()
    {
        const int Senders = 60;

        // A sender that is silent for a quarter of a second counts as replaced. On a busy computer that may happen at any time, so the test then
        // tries again.
        var patience = Stopwatch.StartNew();
        while (patience.Elapsed < Limits.Unexpected)
        {
            await using UdpEnd end = await UdpEnd.StartAsync();
            Socket[] senders = [.. Enumerable.Range(0, Senders).Select(_ => end.CreateSender())];
            long start = Stopwatch.GetTimestamp();
            for (int half = 0; half < 2; half++)
            {
                for (int i = 0; i < Senders; i++)
                    await end.SendAsync(senders[i], Datagram($"{i}{"ab"[half]}"));
            }

            bool isLate = false;
            await end.Reader.UntilAsync(statistics =>
            {
                isLate = Stopwatch.GetTimestamp() - start > Stopwatch.Frequency / 4;
                return isLate || statistics.MotionFrames == Senders;
            });
            if (isLate)
                continue;

            Assert.Equal(Enumerable.Range(0, Senders), end.Reader.GetAvatarStatistics().Select(avatar => avatar.Sender));
            Assert.Equal(0, end.Reader.GetStatistics().BytesSkipped);
            return;
        }

        Assert.Fail("The machine makes pauses all the time.");
    }

    [Fact]
    public async Task The_largest_datagrams_lose_nothing()
    {
        const int Largest = 65_507;
        await using UdpEnd end = await UdpEnd.StartAsync();
        using FrameQueue queue = end.Reader.OpenQueue();
        Socket sender = end.CreateSender();
        sender.SendBufferSize = 4 * Largest;
        try
        {
            foreach (byte[] datagram in TestPackets.Motions(0, 200).Chunk(Largest))
            {
                await end.SendAsync(sender, datagram);
                await end.DrainedAsync();
            }
        }
        catch (SocketException exception) when (exception.SocketErrorCode == SocketError.MessageSize)
        {
            Assert.Skip("This system sends no datagrams of 65,507 bytes.");
        }

        await end.Reader.WaitForFramesAsync(200);
        Assert.Equal((0L, 0L, 296_000L), (end.Reader.GetStatistics().BytesSkipped, end.Reader.GetStatistics().Lost, end.Reader.GetStatistics().BytesReceived));
    }

    [Fact]
    public async Task Readers_of_one_port_all_get_broadcasts_and_one_gets_unicasts()
    {
        await using UdpEnd first = await UdpEnd.StartAsync(options =>
        {
            options.LocalAddress = null;
            options.SharePort = true;
        });
        await using UdpEnd second = await UdpEnd.StartAsync(options =>
        {
            options.LocalAddress = null;
            options.SharePort = true;
            options.Port = first.EndPoint.Port;
        });
        using var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp) { EnableBroadcast = true };
        for (int i = 0; i < 20; i++)
            sender.SendTo(TestPackets.Motion(i), new IPEndPoint(IPAddress.Loopback, first.EndPoint.Port));

        await Limits.UntilAsync(() => first.Reader.GetStatistics().MotionFrames + second.Reader.GetStatistics().MotionFrames >= 20);
        Assert.Equal(20, first.Reader.GetStatistics().MotionFrames + second.Reader.GetStatistics().MotionFrames);
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Only Linux broadcasts on the loopback network.");

        for (int i = 20; i < 40; i++)
            sender.SendTo(TestPackets.Motion(i), new IPEndPoint(IPAddress.Parse("127.255.255.255"), first.EndPoint.Port));

        await Limits.UntilAsync(() => first.Reader.GetStatistics().MotionFrames + second.Reader.GetStatistics().MotionFrames >= 60);
        Assert.Equal(60, first.Reader.GetStatistics().MotionFrames + second.Reader.GetStatistics().MotionFrames);
    }

    private static byte[] Datagram(string text)
    {
        byte[] packet = TestPackets.Motion(int.Parse(text.TrimEnd('a', 'b'), provider: null));
        return text[^1] switch
        {
            'a' => packet[..1024],
            'b' => packet[1024..],
            _ => packet,
        };
    }
}
