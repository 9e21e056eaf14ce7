using System.Buffers.Binary;
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text;
using NeuronMocap.Recording;
using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tool.Relay;
using NeuronMocap.Tool.Relay.Destinations;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Relay;

// Poses for other programs, from a file to the datagrams.
public sealed class PoseDestinationTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly Socket _receiver = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp) { ReceiveBufferSize = 4_000_000 };

    public PoseDestinationTests() => _receiver.Bind(new IPEndPoint(IPAddress.Loopback, 0));

    public void Dispose()
    {
        _folder.Dispose();
        _receiver.Dispose();
    }

    [Fact]
    public async Task Vmc_gets_the_chosen_avatar()
    {
        ToolResult result = await RelayAsync($"vmc://{_receiver.LocalEndPoint}/Bob", "--pose-rate", "0", "--pose-scale", "0.5", "--vmc-move", "root");
        Assert.Equal(0, result.ExitCode);
        Assert.Contains($"Sending poses to vmc://{_receiver.LocalEndPoint}/Bob", result.Output);
        List<byte[]> datagrams = Receive();

        // Bob's hips are at 200 cm, and the scale halves that.
        byte[] root = Find(datagrams[^4], "/VMC/Ext/Root/Pos\0\0\0,sfffffff\0\0\0root\0\0\0\0");
        Assert.Equal([-1f, 0f, 0f, 0f, 0f, 0f, 1f], Numbers(root));
        Assert.All(datagrams, static datagram => Assert.InRange(datagram.Length, 1, 1400));
        CheckSummary(result, datagrams.Count(static datagram => Contains(datagram, "/VMC/Ext/T\0")));
    }

    [Fact]
    public async Task Plain_osc_gets_all_avatars()
    {
        ToolResult result = await RelayAsync($"osc://{_receiver.LocalEndPoint}", "--pose-rate", "0", "--osc-space", "local");
        Assert.Equal(0, result.ExitCode);
        List<byte[]> datagrams = Receive();
        Assert.Equal([100f, 0f, 0f, 0f, 0f, 0f, 1f], Numbers(Find(datagrams.Last(static datagram => Contains(datagram, "/Ann/Hips")), "/neuron/Ann/Hips\0\0\0\0,fffffff\0\0\0\0")));
        Assert.Equal([200f, 0f, 0f, 0f, 0f, 0f, 1f], Numbers(Find(datagrams.Last(static datagram => Contains(datagram, "/Bob/Hips")), "/neuron/Bob/Hips\0\0\0\0,fffffff\0\0\0\0")));
        CheckSummary(result, datagrams.Count(static datagram => Contains(datagram, "/frame\0")));
    }

    [Fact]
    public async Task Another_program_is_a_source_over_vmc()
    {
        int port = FreePort.Next();
        await using Broadcaster demo = Broadcaster.StartDemo();
        await using var reader = new NeuronReader("127.0.0.1", demo.LocalEndPoint!.Port);
        await using var sender = new VmcSender(reader, new VmcSenderOptions { Port = port });
        sender.Start();
        reader.Start();
        ToolResult result = await ToolRunner.RunAsync("watch", $"vmc://127.0.0.1:{port}", "--json", "--frames", "3");
        Assert.Equal(0, result.ExitCode);
        Assert.Contains($"\"source\":\"vmc://127.0.0.1:{port}\"", result.Output[0], StringComparison.Ordinal);
        Assert.Equal(3, result.Output.Count(static line => line.StartsWith("{\"type\":\"frame\",\"avatar\":0,\"name\":\"VMC\"", StringComparison.Ordinal)));
    }

    [Fact]
    public async Task What_a_source_over_vmc_rejects_is_in_the_summary()
    {
        int port = FreePort.Next();
        using var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        sender.Connect(IPAddress.Loopback, port);
        byte[] pose = [.. Bundle("/VMC/Ext/Bone/Pos\0\0\0,sfffffff\0\0\0Hips\0\0\0\0", new byte[24], [0x3F, 0x80, 0, 0]), .. Part("/VMC/Ext/OK\0,i\0\0", [0, 0, 0, 1])];
        Task<ToolResult> watching = ToolRunner.RunAsync("watch", $"vmc://127.0.0.1:{port}", "--json", "--frames", "3");
        while (!watching.IsCompleted)
        {
            // The port may not be open yet. Afterwards each pose has garbage before it.
            sender.Send("GET / HTTP/1.1"u8, SocketFlags.None, out _);
            sender.Send(pose, SocketFlags.None, out _);
            await Task.Yield();
        }

        ToolResult result = await watching;
        Assert.Equal(0, result.ExitCode);
        Assert.Matches("\"rejectedMessages\":[1-9]", result.Output[^1]);
    }

    [Fact]
    public async Task A_performer_who_is_not_in_the_stream_is_said()
    {
        ToolResult result = await RelayAsync($"vmc://{_receiver.LocalEndPoint}/Nobody", "--pose-rate", "0");
        Assert.EndsWith("; no performer 'Nobody'; arriving: Ann, Bob", Assert.Single(result.Output, static line => line.Contains(" poses, ", StringComparison.Ordinal)), StringComparison.Ordinal);

        await using Broadcaster demo = Broadcaster.StartDemo();
        await using var reader = new NeuronReader("127.0.0.1", demo.LocalEndPoint!.Port);
        Assert.True(Destination.TryParse($"osc://{_receiver.LocalEndPoint}/7", out Destination? destination, out _));
        await using Outlet outlet = destination.Open(reader, overwrite: false);
        var flow = new RelayFlow(reader, "demo", [outlet]);
        Assert.Contains(": idle, ", flow.ToLine(DateTime.Now), StringComparison.Ordinal);
        reader.Start();
        await Limits.UntilAsync(() =>
        {
            flow.Update();
            return flow.ToLine(DateTime.Now).Contains($"  {outlet.Name}: no performer 7; arriving: 0, ", StringComparison.Ordinal);
        });
        Assert.Equal("unmatched", Assert.Single(flow.Figures).State);
    }

    [Fact]
    public async Task Poses_that_a_rate_leaves_out_are_in_the_summary()
    {
        ToolResult result = await RelayAsync($"vmc://{_receiver.LocalEndPoint}/Bob", "--pose-rate", "0.01");
        Assert.Contains(result.Output, static line => line.Contains(": 1 pose, 0 dropped, 14 left out by rate, ", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("vmc://studio", "vmc://studio:39539")]
    [InlineData("VMC://[::1]/Bob", "vmc://[::1]:39539/Bob")]
    [InlineData("vmc://127.0.0.1:1/0", "vmc://127.0.0.1:1/0")]
    public void Vmc_has_a_usual_port(string text, string expected)
    {
        Assert.True(Destination.TryParse(text, out Destination? destination, out _));
        Assert.Equal(expected, destination.Text);
    }

    [Fact]
    public async Task A_host_name_without_an_address_is_one_line()
    {
        // No name server is asked for such a name.
        foreach (string destination in (string[])["vmc://a..b:39539", "osc://a..b:9000/0"])
        {
            ToolResult result = await ToolRunner.RunAsync("relay", "demo", destination);
            Assert.Equal(1, result.ExitCode);
            Assert.StartsWith($"neuron-mocap: {destination}: the host name a..b has no address (", Assert.Single(result.Error), StringComparison.Ordinal);
        }
    }

    [Fact]
    public async Task A_host_name_that_is_too_long_is_one_line()
    {
        string destination = $"vmc://{new string('a', 300)}:39539";
        ToolResult result = await ToolRunner.RunAsync("relay", "demo", destination);
        Assert.Equal(1, result.ExitCode);
        Assert.Equal($"neuron-mocap: {destination}: no computer can have this name. It is too long.", Assert.Single(result.Error));
    }

    [Fact]
    public async Task A_port_where_nobody_receives_is_said()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Only Linux surely reports refusals on loopback.");
        await using Broadcaster demo = Broadcaster.StartDemo();
        await using var reader = new NeuronReader("127.0.0.1", demo.LocalEndPoint!.Port);
        Assert.True(Destination.TryParse($"vmc://127.0.0.1:{FreePort.Next()}", out Destination? destination, out _));
        await using Outlet outlet = destination.Open(reader, overwrite: false);
        var flow = new RelayFlow(reader, "demo", [outlet]);
        reader.Start();
        await Limits.UntilAsync(() =>
        {
            flow.Update();
            return flow.ToLine(DateTime.Now).Contains($"  {outlet.Name}: no program receives on that port, ", StringComparison.Ordinal);
        });
    }

    [Theory]
    [InlineData("'vmc://:39539' names no computer to send to. Use vmc://HOST:PORT, or vmc://HOST:PORT/AVATAR. The port is 39539 if it is left out.", "demo", "vmc://:39539")]
    [InlineData("'vmc://39539' names no computer to send to.", "demo", "vmc://39539")]
    [InlineData("'vmc://studio:0' names no computer to send to.", "demo", "vmc://studio:0")]
    [InlineData("'osc://studio/0' names no computer and port", "demo", "osc://studio/0")]
    [InlineData("vmc://a:1/0 and osc://a:1 are the same destination.", "demo", "vmc://a:1/0", "osc://a:1")]
    [InlineData("vmc://127.0.0.1:7012 would send the source udp://:7012 to itself.", "udp://:7012", "vmc://127.0.0.1:7012")]
    [InlineData("vmc://127.0.0.1:7012 would send the source vmc://:7012 to itself.", "vmc://:7012", "vmc://127.0.0.1:7012")]
    [InlineData("--local-address needs a server or udp://:PORT as the source", "vmc://:7012", "vmc://a:1", "--local-address", "127.0.0.1")]
    [InlineData("--pose-rate needs a destination vmc:// or osc://", "demo", "tcp://:0", "--pose-rate", "30")]
    [InlineData("--pose-scale needs a destination vmc:// or osc://", "demo", "tcp://:0", "--pose-scale", "2")]
    [InlineData("--vmc-move needs a destination vmc://", "demo", "osc://a:1", "--vmc-move", "root")]
    [InlineData("--vmc-move: 'feet' is not hips or root.", "demo", "vmc://a:1", "--vmc-move", "feet")]
    [InlineData("--osc-space needs a destination osc://", "demo", "vmc://a:1", "--osc-space", "local")]
    [InlineData("--osc-space: 'moon' is not world or local.", "demo", "osc://a:1", "--osc-space", "moon")]
    [InlineData("--pose-rate: '1001' is not 0, or a number from 0.01 to 1000.", "demo", "osc://a:1", "--pose-rate", "1001")]
    [InlineData("--pose-scale: '0' is not a number", "demo", "osc://a:1", "--pose-scale", "0")]
    public async Task A_wrong_command_line_says_what_is_wrong(string expected, params string[] arguments)
    {
        ToolResult result = await ToolRunner.RunAsync(["relay", .. arguments]);
        Assert.Equal(2, result.ExitCode);
        Assert.Contains(expected, Assert.Single(result.Error), StringComparison.Ordinal);
    }

    private static byte[] Bundle(string head, params byte[][] arguments) => [.. Encoding.ASCII.GetBytes("#bundle\0\0\0\0\0\0\0\0\u0001"), .. Part(head, arguments)];

    // One message of a bundle, behind its length.
    private static byte[] Part(string head, params byte[][] arguments)
    {
        byte[] message = [.. Encoding.ASCII.GetBytes(head), .. arguments.SelectMany(static argument => argument)];
        byte[] length = new byte[4];
        BinaryPrimitives.WriteInt32BigEndian(length, message.Length);
        return [.. length, .. message];
    }

    // Every frame of the file was sent, or a newer one took its place. The last frame of each avatar is always sent.
    private static void CheckSummary(ToolResult result, int sent) =>
        Assert.Contains(result.Output, line => line.Contains(string.Create(CultureInfo.InvariantCulture, $": {sent} poses, "), StringComparison.Ordinal));

    private Task<ToolResult> RelayAsync(params string[] arguments)
    {
        using (RecordingWriter writer = RecordingWriter.Create(_folder["take.nmrec"]))
        {
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "127.0.0.1:50000", "127.0.0.1:7001"));
            for (int i = 0; i < 8; i++)
            {
                foreach ((int avatar, string name) in ((int, string)[])[(0, "Ann"), (1, "Bob")])
                {
                    float[] values = new float[180];
                    values[0] = 100 * (avatar + 1);
                    var header = new MotionHeader { AvatarIndex = avatar, AvatarName = new AvatarName(name), FrameIndex = (uint)i };
                    writer.WriteBytes(TimeSpan.FromMilliseconds(12 * i), 0, FrameServer.Motion(header, values));
                }
            }

            writer.CloseConnection(TimeSpan.FromMilliseconds(100), 0, "closed");
        }

        return ToolRunner.RunAsync(["relay", _folder["take.nmrec"], .. arguments]);
    }

    private List<byte[]> Receive()
    {
        List<byte[]> datagrams = [];
        byte[] buffer = new byte[65_536];
        while (_receiver.Available > 0)
            datagrams.Add(buffer[.._receiver.Receive(buffer)]);

        return datagrams;
    }

    private static bool Contains(byte[] datagram, string text) => datagram.AsSpan().IndexOf(Encoding.ASCII.GetBytes(text)) >= 0;

    // The seven numbers behind the head of a message.
    private static byte[] Find(byte[] datagram, string head)
    {
        int at = datagram.AsSpan().IndexOf(Encoding.ASCII.GetBytes(head));
        Assert.True(at >= 0, head);
        return datagram[(at + head.Length)..(at + head.Length + 28)];
    }

    private static float[] Numbers(byte[] bytes) =>
        [.. Enumerable.Range(0, 7).Select(i => BinaryPrimitives.ReadSingleBigEndian(bytes.AsSpan(4 * i)))];
}
