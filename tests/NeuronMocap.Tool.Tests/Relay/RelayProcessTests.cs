using System.Net;
using System.Net.Sockets;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Server;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Relay;

// Runs of relay as its own process, with clients.
public sealed class RelayProcessTests : IDisposable
{
    private const string Listening = "Listening on ";
    private const string Commands = "Commands on ";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task The_demo_reaches_all_destinations_until_an_interrupt()
    {
        ToolProcess.SkipWithoutInterrupt();
        using var receiver = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp) { ReceiveBufferSize = 4_000_000 };
        receiver.Bind(new IPEndPoint(IPAddress.Loopback, 0));

        // Reads all the time, because a system may give a smaller buffer, which holds the datagrams of three seconds.
        Task<byte[]> datagrams = ReceiveUntilEmptyAsync(receiver);
        using var relay = new ToolProcess(
            "neuron-mocap", "relay", "demo", "tcp://127.0.0.1:0", $"udp://{receiver.LocalEndPoint}", _folder["demo.nmrec"], _folder["demo.bvh"]);
        IPEndPoint server = await ReadAddressAsync(relay, Listening);
        using Socket idle = await ConnectAsync(server);
        using Socket client = await ConnectAsync(server);
        Task<byte[]> reading = ReadToEndAsync(client, enough: 60 * 1480, () => relay.Interrupt());
        byte[] received = await reading.Soon();
        idle.Dispose();
        Task<string> rest = relay.Output.ReadToEndAsync(TestContext.Current.CancellationToken);
        Assert.Equal(0, await relay.WaitForExitAsync());
        Assert.Contains(" dropped", await rest, StringComparison.Ordinal);

        // The client came after the first frames. From there on, it has everything.
        byte[] recorded = RelayRunTests.ReadBytes(_folder["demo.nmrec"]);
        Assert.True(MotionHeader.TryRead(received, out MotionHeader first));
        int start = (int)first.FrameIndex!.Value * first.PacketSize;
        Assert.Equal(recorded[start..], received);

        // Frames end before bytes do when the relay is stopped.
        Assert.InRange(BvhDocument.Load(_folder["demo.bvh"]).FrameCount, 60, recorded.Length / first.PacketSize);
        using var last = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        last.SendTo([], receiver.LocalEndPoint!);
        Assert.Equal(recorded, await datagrams.Soon());
    }

    [Fact]
    public async Task A_client_stays_while_the_source_dies_and_comes_back()
    {
        ToolProcess.SkipWithoutInterrupt();
        byte[][] packets = [FrameServer.Motion(0, 1, 2), FrameServer.Motion(1, 3, 4)];
        using FrameServer source = FrameServer.Sending(packets);
        using var relay = new ToolProcess("neuron-mocap", "relay", source.Address, "tcp://127.0.0.1:0");
        using Socket client = await ConnectAsync(await ReadAddressAsync(relay, Listening));
        byte[] received = await ReadToEndAsync(client, enough: 5 * packets[0].Length, () => relay.Interrupt()).Soon();
        int start = received.AsSpan().StartsWith(packets[0]) ? 0 : 1;
        for (int offset = 0, index = start; offset < received.Length; offset += packets[0].Length, index++)
            Assert.Equal(packets[index % 2], received[offset..(offset + packets[0].Length)]);

        Assert.Equal(0, await relay.WaitForExitAsync());
    }

    [Fact]
    public async Task Commands_reach_the_source()
    {
        ToolProcess.SkipWithoutInterrupt();
        await using Broadcaster source = Broadcaster.StartDemo(rotationOrder: RotationOrder.ZYX);
        await using var channel = new CommandServer(source, new CommandServerOptions { Port = 0 });
        channel.Start();
        using var relay = new ToolProcess(
            "neuron-mocap", "relay", $"{source.LocalEndPoint}", "tcp://127.0.0.1:0", "--command-port", $"{channel.LocalEndPoint!.Port}", "--commands", "tcp://127.0.0.1:0");
        IPEndPoint commands = await ReadAddressAsync(relay, Commands);
        await using (var client = new NeuronCommandClient("127.0.0.1", commands.Port))
        {
            Assert.Equal(RotationOrder.ZYX, await client.GetRotationOrderAsync(TestContext.Current.CancellationToken).Soon());
            await client.ZeroOutAllAsync(TestContext.Current.CancellationToken).Soon();
        }

        relay.Interrupt();
        Assert.Equal(0, await relay.WaitForExitAsync());
    }

    private static async Task<IPEndPoint> ReadAddressAsync(ToolProcess program, string announcement)
    {
        while (await program.Output.ReadLineAsync(TestContext.Current.CancellationToken) is { } line)
        {
            if (line.StartsWith(announcement, StringComparison.Ordinal))
                return IPEndPoint.Parse(line[announcement.Length..]);
        }

        throw new InvalidDataException($"The program did not write '{announcement}'. {await program.ReadErrorAsync()}");
    }

    private static async Task<Socket> ConnectAsync(IPEndPoint server)
    {
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        await socket.ConnectAsync(server, TestContext.Current.CancellationToken).AsTask().Soon();
        return socket;
    }

    // Receives datagrams until one of them is empty.
    private static async Task<byte[]> ReceiveUntilEmptyAsync(Socket receiver)
    {
        using var bytes = new MemoryStream();
        byte[] buffer = new byte[65_536];
        int count;
        while ((count = await receiver.ReceiveAsync(buffer.AsMemory(), TestContext.Current.CancellationToken)) > 0)
            bytes.Write(buffer, 0, count);

        return bytes.ToArray();
    }

    // Calls the action once after enough bytes.
    private static async Task<byte[]> ReadToEndAsync(Socket socket, int enough, Action then)
    {
        using var bytes = new MemoryStream();
        byte[] buffer = new byte[65_536];
        int count;
        bool isEnough = false;
        while ((count = await socket.ReceiveAsync(buffer.AsMemory(), TestContext.Current.CancellationToken)) > 0)
        {
            bytes.Write(buffer, 0, count);
            if (isEnough || bytes.Length < enough)
                continue;

            isEnough = true;
            then();
        }

        socket.Dispose();
        return bytes.ToArray();
    }
}
