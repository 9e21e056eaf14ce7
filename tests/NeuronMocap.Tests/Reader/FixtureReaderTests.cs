using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Frames;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// The streams of a foreign encoder over real sockets and from sources, up to the frames that an application sees.
public partial class FixtureReaderTests
{
    public static TheoryData<string> Names => WrittenStreams.Names;

    [Theory]
    [MemberData(nameof(Names))]
    public async Task Over_tcp_whole(string name) => await OverTcpAsync(name, int.MaxValue);

    [Theory]
    [MemberData(nameof(Names))]
    public async Task Over_tcp_byte_by_byte(string name) => await OverTcpAsync(name, 1);

    [Theory]
    [MemberData(nameof(Names))]
    public async Task Over_tcp_in_odd_pieces(string name) => await OverTcpAsync(name, 777);

    [Theory]
    [MemberData(nameof(Names))]
    public async Task Over_udp_coalesced(string name) => await OverUdpAsync(name, 60_000);

    [Theory]
    [MemberData(nameof(Names))]
    public async Task Over_udp_in_datagrams_of_1024(string name) => await OverUdpAsync(name, 1024);

    [Theory]
    [MemberData(nameof(Names))]
    public async Task From_a_stream(string name)
    {
        foreach (int pieceSize in (int[])[1, 63, 777, int.MaxValue])
        {
            StreamFixture fixture = Load(name);
            FedStream stream = new FedStream().Feed([.. fixture.Bytes.Chunk(pieceSize)]).End();
            await FromAsync(fixture, new NeuronReader(stream, SourceReaderTests.Options(ReceiveThread.Dedicated)));
        }
    }

    /// <summary>Loads a stream. Derived classes load another encoder's streams.</summary>
    internal virtual StreamFixture Load(string name) => StreamFixture.Load(name);

    private async Task OverTcpAsync(string name, int pieceSize)
    {
        StreamFixture fixture = Load(name);
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        using FrameQueue queue = reader.OpenQueue();
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendPiecesAsync(fixture.Bytes, pieceSize);
        connection.Close();
        await reader.Completion.Soon();
        AssertFrames(fixture, queue);
        Assert.Equal(fixture.Bytes.Length, reader.GetStatistics().BytesReceived);
    }

    private static async Task FromAsync(StreamFixture fixture, NeuronReader reader)
    {
        await using (reader)
        {
            using FrameQueue queue = reader.OpenQueue();
            reader.Start();
            await reader.Completion.Soon();
            AssertFrames(fixture, queue);
            Assert.Equal(fixture.Bytes.Length, reader.GetStatistics().BytesReceived);
        }
    }

    private async Task OverUdpAsync(string name, int datagramSize)
    {
        StreamFixture fixture = Load(name);
        await using var reader = new NeuronReader(new NeuronReaderOptions { Transport = TransportKind.Udp, LocalAddress = IPAddress.Loopback, Port = 0 });
        using FrameQueue queue = reader.OpenQueue();
        await reader.StartAsync().Soon();
        using var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        sender.Connect(reader.Status.LocalEndPoint!);
        foreach (byte[] datagram in fixture.Bytes.Chunk(datagramSize))
            sender.Send(datagram);

        await Limits.UntilAsync(() => queue.Count >= fixture.Expected.Count);
        AssertFrames(fixture, queue);
    }

    private static void AssertFrames(StreamFixture fixture, FrameQueue queue)
    {
        int next = 0;
        int count = queue.Pump<AvatarFrame>(frame =>
        {
            ExpectedPacket expected = fixture.Expected[next++];
            if (frame is StudioCalculationFrame studio)
            {
                Assert.Equal("studioCalculation", expected.Type);
                Assert.Equal((expected.Avatar, expected.Name, expected.Index), (studio.AvatarIndex, studio.AvatarName, studio.FrameIndex));
                StudioCalculations.AssertFixture(studio);
                return;
            }

            Assert.Equal(frame is MotionFrame ? "frame" : "calculation", expected.Type);
            AssertFrame(expected, frame);
            if (frame is MotionFrame motion)
            {
                Assert.Equal(expected.Displacement ?? true, motion.Header.HasDisplacement);
                Assert.Equal(expected.Reference ?? false, motion.Header.HasReference);
                Assert.Equal((motion.Header.HasDisplacement, motion.Header.HasReference), (motion.Layout.HasDisplacement, motion.Layout.HasReference));
            }
        });
        Assert.Equal(fixture.Expected.Count, count);
    }

    private static void AssertFrame(ExpectedPacket expected, AvatarFrame frame)
    {
        Assert.Equal((expected.Avatar, expected.Name, expected.Index), (frame.AvatarIndex, frame.AvatarName, frame.FrameIndex));
        Assert.Equal(expected.Values.Select(BitConverter.SingleToInt32Bits), frame.Values.ToArray().Select(BitConverter.SingleToInt32Bits));
    }
}
