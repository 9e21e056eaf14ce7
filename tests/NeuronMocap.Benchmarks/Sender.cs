using System.Diagnostics;
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Benchmarks;

// A server in its own process: sends one client so many frames as fast as they are taken, and ends.
internal sealed class Sender : IDisposable
{
    public const int FrameSize = 1480;

    private readonly Process _process;

    private Sender(Process process, int port)
    {
        _process = process;
        Port = port;
    }

    public int Port { get; }

    public static async Task<Sender> StartAsync(int perWrite, int frames)
    {
        string arguments = $"exec \"{typeof(Sender).Assembly.Location}\" send --per-write {perWrite} --frames {frames}";
        Process process = Process.Start(new ProcessStartInfo("dotnet", arguments) { RedirectStandardOutput = true, UseShellExecute = false })
            ?? throw new InvalidOperationException("The sender did not start.");
        string port = await process.StandardOutput.ReadLineAsync() ?? throw new InvalidOperationException("The sender has no port.");
        return new Sender(process, int.Parse(port, CultureInfo.InvariantCulture));
    }

    public static void Run(int perWrite, int frames)
    {
        byte[] block = new byte[perWrite * FrameSize];
        for (int i = 0; i < perWrite; i++)
        {
            var header = new MotionHeader { HasDisplacement = true, AvatarName = new AvatarName("Char00") };
            PacketEncoder.WriteMotion(block.AsSpan(i * FrameSize), header, new float[354]);
        }

        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        Console.WriteLine(((IPEndPoint)listener.LocalEndpoint).Port);
        using Socket socket = listener.AcceptSocket();
        socket.NoDelay = true;
        for (int sent = 0; sent < frames; sent += perWrite)
            SendAll(socket, block.AsSpan(0, Math.Min(perWrite, frames - sent) * FrameSize));

        socket.Shutdown(SocketShutdown.Send);
        socket.Receive(new byte[1]);
    }

    public void Dispose()
    {
        _process.WaitForExit();
        _process.Dispose();
    }

    private static void SendAll(Socket socket, ReadOnlySpan<byte> bytes)
    {
        while (bytes.Length > 0)
            bytes = bytes[socket.Send(bytes)..];
    }
}
