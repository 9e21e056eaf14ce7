using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Tests.Network;

// A reader's UDP port and its senders. Never sends more at a time than the system buffers.
internal sealed class UdpEnd(NeuronReader reader) : IAsyncDisposable
{
    private readonly List<Socket> _sockets = [];
    private long _sent;

    public NeuronReader Reader => reader;

    public IPEndPoint EndPoint => (IPEndPoint)reader.Status.LocalEndPoint!;

    public static async Task<UdpEnd> StartAsync(Action<NeuronReaderOptions>? configure = null)
    {
        var options = new NeuronReaderOptions
        {
            Transport = TransportKind.Udp,
            LocalAddress = IPAddress.Loopback,
            Port = 0,
            SilenceTimeout = TimeSpan.FromMilliseconds(100),
            StopTimeout = Limits.Unexpected,
            Reconnect = { Enabled = false },
        };
        configure?.Invoke(options);
        var reader = new NeuronReader(options);
        await reader.StartAsync().Soon();
        return new UdpEnd(reader);
    }

    // A socket that sends from its own address.
    public Socket CreateSender(string? address = null)
    {
        IPAddress from = address is null ? EndPoint.Address : IPAddress.Parse(address);
        var socket = new Socket(from.AddressFamily, SocketType.Dgram, ProtocolType.Udp);

        // Mono shares every port of UDP unless told otherwise. Two senders then sometimes get the same address.
        socket.SetSocketOption(SocketOptionLevel.Socket, SocketOptionName.ReuseAddress, optionValue: false);
        socket.Bind(new IPEndPoint(from, 0));
        socket.Connect(EndPoint);
        _sockets.Add(socket);
        return socket;
    }

    // Waits at intervals until the reader has received what was sent, except for incomplete packets.
    public async Task SendAsync(Socket socket, ReadOnlyMemory<byte> datagram)
    {
        socket.Send(datagram.Span);
        _sent++;
        if (_sent % 32 == 0)
            await DrainedAsync();
    }

    public Task DrainedAsync() => Limits.UntilAsync(() => reader.Completion.IsCompleted || IsEmpty());

    public async ValueTask DisposeAsync()
    {
        _sockets.ForEach(socket => socket.Dispose());
        await reader.DisposeAsync();
    }

    // Whether the port's buffer is empty, as reported by the system. On other systems, waits for the time of a few datagrams.
    private bool IsEmpty()
    {
        if (!OperatingSystem.IsLinux())
            return true;

        string port = $":{EndPoint.Port:X4} ";
        string file = EndPoint.AddressFamily == AddressFamily.InterNetwork ? "/proc/net/udp" : "/proc/net/udp6";
        return File.ReadLines(file).All(line => !line.Contains(port, StringComparison.Ordinal) || line.Contains(":00000000 00:", StringComparison.Ordinal));
    }
}
