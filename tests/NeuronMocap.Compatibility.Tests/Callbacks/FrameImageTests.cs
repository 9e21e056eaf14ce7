using System.Collections.Concurrent;
using System.Net;
using System.Net.Sockets;
using System.Runtime.InteropServices;
using NeuronDataReaderWraper;
using NeuronMocap.Compatibility.Tests.Infrastructure;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Callbacks;

// The memory behind the pointers, byte for byte.
public sealed class FrameImageTests
{
    // Programs may keep the address of the first frame and read it at any time.
    [Fact]
    public async Task Packets_of_any_size_use_one_address_per_connection()
    {
        byte[][] packets =
        [
            TestPackets.Motion(1, count: 180), TestPackets.Motion(2), TestPackets.Calculation(3), TestPackets.Motion(4, count: 10_224),
            DataReplies.BvhText(new string('x', ProtocolConstants.MaxCommandPayload)), TestPackets.Motion(5, count: 180),
        ];
        var addresses = new ConcurrentQueue<(IntPtr Header, IntPtr Data)>();
        using var log = new CallbackLog();
        NeuronDataReader.BRRegisterFrameDataCallback(IntPtr.Zero, Add);
        NeuronDataReader.BRRegisterCalculationDataCallback(IntPtr.Zero, Add);
        NeuronDataReader.BRRegisterCommandDataCallback(IntPtr.Zero, Add);
        using PacketServer server = await PacketServer.ConnectAsync(log);

        await server.SendAsync(packets);
        await Limits.UntilAsync(() => addresses.Count == packets.Length);

        Assert.Single(addresses.Distinct());

        void Add(IntPtr customObject, IntPtr socket, IntPtr header, IntPtr data) => addresses.Enqueue((header, data));
    }

    [Theory]
    [InlineData(180)]
    [InlineData(186)]
    [InlineData(354)]
    [InlineData(360)]
    [InlineData(1)]
    [InlineData(10_224)]
    public async Task A_frame_with_the_new_header_is_delivered_unchanged(int count)
    {
        byte[] packet = new byte[64 + (4 * count)];
        var header = new MotionHeader
        {
            Version = DataVersion.Studio,
            HasDisplacement = true,
            HasReference = true,
            AvatarIndex = 0x01020304,
            AvatarName = new AvatarName("陈-0123456789-0123456789-01234"),
            FrameIndex = uint.MaxValue,
            Reserved = 4,
            Reserved1 = 0x11223344,
            Reserved2 = 0x55667788,
        };
        PacketEncoder.WriteMotion(packet, header, [.. Enumerable.Range(0, count).Select(static i => -i / 7f)]);
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);

        // The second packet is received into memory that exists already.
        await server.SendAsync(TestPackets.Motion(1, count: 180), packet, packet);
        await log.FramesAsync(3);

        foreach (LoggedFrame frame in log.Frames.Skip(1))
        {
            Assert.Equal(packet[..64], frame.Header);
            Assert.True(MemoryMarshal.AsBytes<float>(frame.Values).SequenceEqual(packet.AsSpan(64)));
            Assert.Equal((CallbackLog.FrameObject, server.Socket), (frame.CustomObject, frame.Socket));
        }
    }

    [Fact]
    public async Task A_frame_with_the_old_header_gets_the_new_header_and_a_counted_index()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);

        await server.SendAsync(
            TestPackets.Motion(7, avatar: 0, name: "First", layout: HeaderLayout.Old),
            TestPackets.Motion(7, avatar: 1, count: 186, name: "Second", layout: HeaderLayout.Old),
            TestPackets.Motion(8, avatar: 0, name: "First", layout: HeaderLayout.Old),
            TestPackets.Motion(8, avatar: 1, count: 186, name: "Second", layout: HeaderLayout.Old));
        await log.FramesAsync(4);

        Assert.Equal(
            ["First 0 0 354 1 0", "Second 1 0 186 0 1", "First 0 1 354 1 0", "Second 1 1 186 0 1"],
            log.Frames.Select(static frame => frame.Motion).Select(static header =>
                $"{header.AvatarName} {header.AvatarIndex} {header.FrameIndex} {header.DataCount} {header.bWithDisp} {header.bWithReference}"));
        foreach ((LoggedFrame frame, int i) in log.Frames.Select(static (frame, i) => (frame, i)))
        {
            BvhDataHeader header = frame.Motion;
            Assert.Equal((0xDDFF, 0xEEFF, 0xDDFF, 0xEEFF), (header.Token1, header.Token2, header.HeaderToken1, header.HeaderToken2));
            Assert.Equal(new NeuronDataReaderWraper.DataVersion { Major = 1, Minor = 1 }, header.DataVersion);
            Assert.Equal(TestPackets.Value(7 + (i / 2), i % 2, 5), frame.Values[5]);
        }
    }

    [Fact]
    public async Task A_new_connection_restarts_the_index()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        await server.SendAsync(TestPackets.Motion(1, layout: HeaderLayout.Old), TestPackets.Motion(2, layout: HeaderLayout.Old));
        await log.FramesAsync(2);
        NeuronDataReader.BRCloseSocket(server.Socket);

        await server.ReconnectAsync(log);
        await server.SendAsync(TestPackets.Motion(3, layout: HeaderLayout.Old));
        await log.FramesAsync(3);

        Assert.Equal([0u, 1u, 0u], log.Frames.Select(static frame => frame.Motion.FrameIndex));
    }

    [Theory]
    [InlineData(338)]
    [InlineData(946)]
    public async Task A_calculation_frame_is_delivered_unchanged_with_its_own_object(int count)
    {
        byte[] packet = TestPackets.Calculation(99, avatar: 3, count);
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);

        await server.SendAsync(TestPackets.Motion(1), packet, TestPackets.Motion(2));
        await log.FramesAsync(2);

        LoggedFrame frame = Assert.Single(log.CalculationFrames);
        Assert.Equal(packet[..64], frame.Header);
        Assert.True(MemoryMarshal.AsBytes<float>(frame.Values).SequenceEqual(packet.AsSpan(64)));
        Assert.Equal((CallbackLog.CalculationObject, server.Socket), (frame.CustomObject, frame.Socket));
        Assert.Equal((3u, 99u), (frame.Calculation.AvatarIndex, frame.Calculation.FrameIndex));
    }

    [Fact]
    public async Task Packets_without_values_are_not_delivered()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);

        await server.SendAsync(TestPackets.Motion(1, count: 0), TestPackets.Calculation(1, count: 0), TestPackets.Motion(2));
        await log.FramesAsync(1);

        Assert.Equal(2u, Assert.Single(log.Frames).Motion.FrameIndex);
        Assert.Empty(log.CalculationFrames);
    }

    // Any split, with a sender each: macOS sends a frame in two datagrams.
    [Fact]
    public async Task Datagrams_are_joined_for_each_sender()
    {
        using var log = new CallbackLog();
        (IntPtr service, IPEndPoint port) = Listen(log);
        using var first = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        using var second = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);

        byte[] one = TestPackets.Motion(1, layout: HeaderLayout.Old);
        byte[] other = TestPackets.Motion(2, layout: HeaderLayout.Old);
        first.SendTo(one.AsSpan(0, 1024), port);
        second.SendTo(other.AsSpan(0, 1024), port);
        first.SendTo(one.AsSpan(1024), port);
        second.SendTo(other.AsSpan(1024), port);
        await log.FramesAsync(2);

        Assert.Equal([TestPackets.Value(1, 0, 353), TestPackets.Value(2, 0, 353)], log.Frames.Select(static frame => frame.Values[353]));
        Assert.All(log.Frames, frame => Assert.Equal((service, 0u), (frame.Socket, frame.Motion.FrameIndex)));
    }

    private static (IntPtr Service, IPEndPoint Port) Listen(CallbackLog log)
    {
        var port = new IPEndPoint(IPAddress.Loopback, FreePort.Next());
        IntPtr service = log.Listen(port.Port);
        Assert.NotEqual(IntPtr.Zero, service);
        return (service, port);
    }
}
