using System.Net;
using System.Net.Sockets;
using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Relay;

// Runs of relay inside the test process.
public sealed class RelayRunTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task A_file_goes_bit_for_bit_to_every_kind_of_destination()
    {
        byte[][] packets = [.. Enumerable.Range(0, 40).Select(static index => FrameServer.Motion((uint)index, new float[354]))];
        byte[] noise = [1, 2, 3];
        WriteRecording(_folder["take.nmrec"], [.. packets[..20], [.. noise, .. packets[20]], .. packets[21..]]);
        using var receiver = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp) { ReceiveBufferSize = 1_000_000 };
        receiver.Bind(new IPEndPoint(IPAddress.Loopback, 0));

        ToolResult result = await ToolRunner.RunAsync(
            "relay", _folder["take.nmrec"], "tcp://127.0.0.1:0", $"udp://{receiver.LocalEndPoint}", _folder["copy.nmrec"], _folder["copy.bvh"]);

        Assert.Equal(0, result.ExitCode);
        byte[] expected = ReadBytes(_folder["take.nmrec"]);
        Assert.Equal(expected, ReadBytes(_folder["copy.nmrec"]));
        Assert.Equal(packets.Length, BvhDocument.Load(_folder["copy.bvh"]).FrameCount);
        var datagrams = new List<byte>();
        byte[] buffer = new byte[65_536];
        while (receiver.Available > 0)
            datagrams.AddRange(buffer[..receiver.Receive(buffer)]);

        Assert.Equal(expected, datagrams);
        Assert.Contains(result.Output, static line => line.StartsWith("40 motion and 0 calculation frames ", StringComparison.Ordinal));
        Assert.Contains($"udp://{receiver.LocalEndPoint}: 40 packets, 0 dropped, {expected.Length / 1e3:0.0} kB", result.Output);
        Assert.Contains($"{_folder["copy.bvh"]}: 40 frames, 0 dropped", result.Output);
    }

    [Fact]
    public async Task A_port_in_use_is_one_line_that_names_the_destination()
    {
        using var other = new TcpListener(IPAddress.Loopback, 0);
        other.Start();
        string taken = $"tcp://{other.LocalEndpoint}";
        ToolResult result = await ToolRunner.RunAsync("relay", "demo", _folder["a.nmrec"], taken);
        Assert.Equal(1, result.ExitCode);
        Assert.StartsWith($"neuron-mocap: {taken}: port ", Assert.Single(result.Error), StringComparison.Ordinal);
        result = await ToolRunner.RunAsync("relay", "127.0.0.1:1", "tcp://127.0.0.1:0", "--commands", taken);
        Assert.Equal(1, result.ExitCode);
        Assert.StartsWith($"neuron-mocap: --commands {taken}: port ", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("a.nmrec")]
    [InlineData("a.bvh")]
    public async Task An_existing_file_is_kept_unless_it_may_be_replaced(string name)
    {
        _folder.Write(name, "old");
        ToolResult result = await ToolRunner.RunAsync("relay", "demo", _folder[name], "--duration", "1");
        Assert.Equal(1, result.ExitCode);
        string line = Assert.Single(result.Error);
        Assert.StartsWith($"neuron-mocap: {_folder[name]}: ", line, StringComparison.Ordinal);
        Assert.EndsWith(" --overwrite replaces it.", line, StringComparison.Ordinal);
        Assert.Equal("old", await File.ReadAllTextAsync(_folder[name], TestContext.Current.CancellationToken));

        WriteRecording(_folder["take.nmrec"], FrameServer.Motion(0, new float[354]));
        Assert.Equal(0, (await ToolRunner.RunAsync("relay", _folder["take.nmrec"], _folder[name], "--overwrite")).ExitCode);
        Assert.NotEqual("old", await File.ReadAllTextAsync(_folder[name], TestContext.Current.CancellationToken));
    }

    [Fact]
    public async Task A_source_that_refuses_ends_with_1_and_what_to_check()
    {
        string address = FrameServer.RefusingAddress();
        ToolResult result = await ToolRunner.RunAsync("relay", address, "tcp://127.0.0.1:0", "--once");
        Assert.Equal(1, result.ExitCode);
        Assert.Contains($"{address} refused the connection", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_file_that_fails_later_does_not_end_the_others()
    {
        using FullDevice full = await FullDevice.LinkAsync(_folder["full.bvh"]);
        WriteRecording(_folder["take.nmrec"], [.. Enumerable.Range(0, 40).Select(static index => FrameServer.Motion((uint)index, new float[354]))]);
        ToolResult result = await ToolRunner.RunAsync("relay", _folder["take.nmrec"], _folder["full.bvh"], _folder["copy.nmrec"], "--overwrite");
        Assert.Equal(1, result.ExitCode);
        Assert.Contains(result.Error, line => line.Contains("full.bvh", StringComparison.Ordinal));
    }

    [Fact]
    public async Task A_terminal_gets_a_table()
    {
        ToolResult result = await ToolRunner.RunOnTerminalAsync(120, "relay", "demo", "tcp://127.0.0.1:0", "--duration", "4");
        Assert.Equal(0, result.ExitCode);
        Assert.Contains(result.Output, static line => line.StartsWith("Listening on 127.0.0.1:", StringComparison.Ordinal));
        if (Screen.IsSupported)
            Assert.Contains(result.Output, static line => line.Contains("waiting for clients", StringComparison.Ordinal));
    }

    internal static void WriteRecording(string path, params byte[][] pieces)
    {
        using RecordingWriter writer = RecordingWriter.Create(path);
        writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "127.0.0.1:50000", "127.0.0.1:7001"));
        for (int i = 0; i < pieces.Length; i++)
            writer.WriteBytes(TimeSpan.FromMilliseconds(i), 0, pieces[i]);

        writer.CloseConnection(TimeSpan.FromMilliseconds(pieces.Length), 0, "closed");
    }

    internal static byte[] ReadBytes(string path)
    {
        var bytes = new List<byte>();
        using RecordingReader reader = RecordingReader.Open(path);
        while (reader.TryRead(out RecordingEntry entry))
        {
            if (entry.Kind == RecordingEntryKind.Bytes)
                bytes.AddRange(entry.Bytes);
        }

        return [.. bytes];
    }
}
