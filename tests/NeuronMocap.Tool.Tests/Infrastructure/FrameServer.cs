using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tool.Tests.Infrastructure;

/// <summary>A server of raw bytes on a free loopback port, which serves one client after the other.</summary>
internal sealed class FrameServer : IDisposable
{
    private readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    private readonly CancellationTokenSource _stop = new();

    private FrameServer() => _listener.Start();

    public string Address => _listener.LocalEndpoint.ToString()!;

    /// <summary>Sends the bytes to each client and closes its connection.</summary>
    public static FrameServer Sending(params byte[][] packets) => Start(async (stream, cancellationToken) =>
    {
        foreach (byte[] packet in packets)
            await stream.WriteAsync(packet, cancellationToken);
    });

    /// <summary>Repeats a packet every millisecond until the client leaves.</summary>
    public static FrameServer Repeating(byte[] packet) => Start(async (stream, cancellationToken) =>
    {
        while (true)
        {
            await stream.WriteAsync(packet, cancellationToken);
            await Task.Delay(1, cancellationToken);
        }
    });

    /// <summary>Sends packets to each client, a few every millisecond, until it leaves.</summary>
    /// <param name="packets">Returns the packet with a number. Called in order, from 0.</param>
    public static FrameServer Pacing(Func<int, byte[]> packets) => Start(async (stream, cancellationToken) =>
    {
        for (int number = 0; ; number++)
        {
            await stream.WriteAsync(packets(number), cancellationToken);
            if (number % 16 == 15)
                await Task.Delay(1, cancellationToken);
        }
    });

    /// <summary>Accepts connections and sends nothing.</summary>
    public static FrameServer Silent() => Start(static (_, cancellationToken) => Task.Delay(Timeout.Infinite, cancellationToken));

    /// <summary>An address without a listener. The system gives its port to nobody while a test connects to it again and again.</summary>
    public static string RefusingAddress() => $"127.0.0.1:{FreePort.Next()}";

    public static byte[] Motion(uint index, params float[] values) =>
        Motion(new MotionHeader { AvatarName = new AvatarName("Char00"), FrameIndex = index, HasDisplacement = true }, values);

    public static byte[] Motion(MotionHeader header, params float[] values)
    {
        byte[] packet = new byte[(header with { ValueCount = values.Length }).PacketSize];
        PacketEncoder.WriteMotion(packet, header, values);
        return packet;
    }

    public static byte[] Calculation(uint index, params float[] values)
    {
        var header = new CalculationHeader { AvatarName = new AvatarName("Char00"), FrameIndex = index };
        byte[] packet = new byte[(header with { ValueCount = values.Length }).PacketSize];
        PacketEncoder.WriteCalculation(packet, header, values);
        return packet;
    }

    public void Dispose()
    {
        _stop.Cancel();
        _listener.Dispose();
        _stop.Dispose();
    }

    private static FrameServer Start(Func<NetworkStream, CancellationToken, Task> serve)
    {
        var server = new FrameServer();
        _ = server.AcceptAsync(serve, server._stop.Token);
        return server;
    }

    private async Task AcceptAsync(Func<NetworkStream, CancellationToken, Task> serve, CancellationToken cancellationToken)
    {
        try
        {
            while (true)
            {
                using Socket client = await _listener.AcceptSocketAsync(cancellationToken);
                using var stream = new NetworkStream(client);
                await ServeAsync(serve, stream, cancellationToken);
            }
        }
        catch (Exception exception) when (exception is OperationCanceledException or SocketException or ObjectDisposedException)
        {
            // The test is over.
        }
    }

    private static async Task ServeAsync(Func<NetworkStream, CancellationToken, Task> serve, NetworkStream stream, CancellationToken cancellationToken)
    {
        try
        {
            await serve(stream, cancellationToken);
        }
        catch (IOException)
        {
            // The client left.
        }
    }
}
