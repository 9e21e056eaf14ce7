using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Tests.Network;

// A reader's UDP port, and those who send to it: never more at a time than the system keeps for it.
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
            Reconnect = { Enabled = false },
        };
        configure?.Invoke(options);
        var reader = new NeuronReader(options);
        await reader.StartAsync().Soon();
        return new UdpEnd(reader);
    }

    // A socket that sends from an address of its own.
    public Socket CreateSender(string? address = null)
    {
        IPAddress from = address is null ? EndPoint.Address : IPAddress.Parse(address);
        var socket = new Socket(from.AddressFamily, SocketType.Dgram, ProtocolType.Udp);
        socket.Bind(new IPEndPoint(from, 0));
        socket.Connect(EndPoint);
        _sockets.Add(socket);
        return socket;
    }

    // Waits from time to time until what was sent has been taken in, packets that are not yet whole left aside.
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

    // What waits in the port's buffer, as the system tells it; elsewhere the time of a few datagrams has to do.
    private bool IsEmpty()
    {
        if (!OperatingSystem.IsLinux())
            return true;

        string port = $":{EndPoint.Port:X4} ";
        string file = EndPoint.AddressFamily == AddressFamily.InterNetwork ? "/proc/net/udp" : "/proc/net/udp6";
        return File.ReadLines(file).All(line => !line.Contains(port, StringComparison.Ordinal) || line.Contains(":00000000 00:", StringComparison.Ordinal));
    }
}
