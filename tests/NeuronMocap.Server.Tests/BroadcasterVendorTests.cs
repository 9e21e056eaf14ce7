using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Server.Tests;

// Clients that parse every receive separately get every avatar and all calculation data, because packets are sent one by one with pauses. The test
// controls the time: it passes when the clients have received what was sent, however busy the machine is.
public sealed class BroadcasterVendorTests
{
    private const int Frames = 25;

    [Theory]
    [InlineData(60, 1)]
    [InlineData(60, 2)]
    [InlineData(60, 4)]
    [InlineData(120, 1)]
    [InlineData(120, 2)]
    public async Task Every_avatar_and_all_calculation_arrive_on_one_port(double rate, int avatars)
    {
        var time = new ManualTime();
        await using var broadcaster = new Broadcaster(Options(rate, avatars), time);
        broadcaster.Start();
        using var client = await VendorClient.ConnectAsync(broadcaster.LocalEndPoint);
        for (int packet = 0; packet < Frames * avatars * 2; packet++)
        {
            if (packet > 0)
                await time.PassAsync();

            await client.ReceiveAsync();
        }

        AssertAll(client.Parser.Motion, avatars);
        AssertAll(client.Parser.Calculation, avatars);
        Assert.Equal((Frames - 1) / rate, time.Seconds, 1.1 / rate);
    }

    [Theory]
    [InlineData(60, 1)]
    [InlineData(60, 8)]
    [InlineData(120, 2)]
    [InlineData(120, 4)]
    public async Task Every_avatar_and_all_calculation_arrive_on_two_ports(double rate, int avatars)
    {
        var time = new ManualTime();
        BroadcasterOptions options = Options(rate, avatars);
        options.CalculationPort = 0;
        await using var broadcaster = new Broadcaster(options, time);
        broadcaster.Start();
        using var motion = await VendorClient.ConnectAsync(broadcaster.LocalEndPoint);
        using var calculation = await VendorClient.ConnectAsync(broadcaster.CalculationEndPoint);
        for (int packet = 0; packet < Frames * avatars; packet++)
        {
            if (packet > 0)
                await time.PassAsync();

            await motion.ReceiveAsync();
            await calculation.ReceiveAsync();
        }

        AssertAll(motion.Parser.Motion, avatars);
        AssertAll(calculation.Parser.Calculation, avatars);
        Assert.Empty(motion.Parser.Calculation);
        Assert.Empty(calculation.Parser.Motion);
    }

    // A client that connects in the middle of a frame starts with the first packet of that frame, and sees no gap.
    [Fact]
    public async Task A_client_that_connects_within_a_frame_gets_all_of_it()
    {
        var time = new ManualTime();
        BroadcasterOptions options = Options(rate: 60, avatars: 2);
        await using var broadcaster = new Broadcaster(options, time);
        broadcaster.Start();
        using TestClient early = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        Expect.Motion((await early.ReadAsync())!, options, avatar: 0, frame: 0);
        await time.PassAsync();
        Expect.Calculation((await early.ReadAsync())!, options, avatar: 0, frame: 0);
        using TestClient late = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        Expect.Motion((await late.ReadAsync())!, options, avatar: 0, frame: 0);
        Expect.Calculation((await late.ReadAsync())!, options, avatar: 0, frame: 0);
        await time.PassAsync();
        Expect.Motion((await late.ReadAsync())!, options, avatar: 1, frame: 0);
        await Limits.UntilAsync(() => broadcaster.GetStatistics().FramesSent == 4);
        Assert.Equal((2L, 0L), (broadcaster.GetStatistics().CalculationFramesSent, broadcaster.GetStatistics().PacketsDropped));
    }

    [Theory]
    [InlineData(60, 2, true, new[] { 0, 2 })]
    [InlineData(60, 4, true, new[] { 0, 2, 4, 6 })]
    [InlineData(60, 8, true, new[] { 0, 2, 4, 6 })]
    [InlineData(60, 9, false, new[] { 0 })]
    [InlineData(120, 4, true, new[] { 0, 2, 4, 6 })]
    [InlineData(120, 5, false, new[] { 0 })]
    [InlineData(2000, 1, false, new[] { 0 })]
    public void Packets_are_spread_when_each_has_two_milliseconds(double rate, int packets, bool isPacketwise, int[] milliseconds)
    {
        var spread = new PacketSpacing(rate, packets);
        Assert.Equal(isPacketwise, spread.IsPacketwise);
        Assert.Equal(milliseconds, milliseconds.Select((_, place) => (int)Math.Round((spread.GetTime(100, place) - 100) * 1000 / rate, 6)));
    }

    private static void AssertAll(IReadOnlyList<(int Avatar, int Frame)> received, int avatars) =>
        Assert.Equal(Enumerable.Range(0, Frames * avatars).Select(packet => (packet % avatars, packet / avatars)), received);

    private static BroadcasterOptions Options(double rate, int avatars)
    {
        BroadcasterOptions options = Expect.Options(avatars);
        options.FrameRate = rate;
        options.WaitForClient = true;
        options.Calculation = TestSource.WriteCalculation;
        return options;
    }

    private sealed class VendorClient(Socket socket) : IDisposable
    {
        private readonly byte[] _buffer = new byte[VendorParser.BufferSize];

        public VendorParser Parser { get; } = new();

        public static async Task<VendorClient> ConnectAsync(IPEndPoint? server)
        {
            var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
            await socket.ConnectAsync(server!, TestContext.Current.CancellationToken).AsTask().Soon();
            return new VendorClient(socket);
        }

        // One receive, which is parsed separately.
        public async Task ReceiveAsync()
        {
            int count = await socket.ReceiveAsync(_buffer.AsMemory(), TestContext.Current.CancellationToken).Soon();
            Assert.NotEqual(0, count);
            Parser.Parse(_buffer.AsSpan(0, count));
        }

        public void Dispose() => socket.Dispose();
    }
}
