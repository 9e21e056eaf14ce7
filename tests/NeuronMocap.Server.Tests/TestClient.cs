using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Server.Tests;

// A TCP client that uses nothing of the library except the scanner. Every read fails on a reset, because each test includes a graceful end.
internal sealed class TestClient : IDisposable
{
    private readonly PacketScanner _scanner = new();
    private readonly byte[] _buffer = new byte[256 * 1024];
    private int _count;

    private TestClient(Socket socket) => Socket = socket;

    public Socket Socket { get; }

    // Whether the stream may end in mid-packet, as it does when the broadcaster stops.
    public bool AllowsCutEnd { get; init; }

    public static async Task<TestClient> ConnectAsync(IPEndPoint? server, bool allowsCutEnd = false)
    {
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        await socket.ConnectAsync(server!, TestContext.Current.CancellationToken).AsTask().Soon();
        return new TestClient(socket) { AllowsCutEnd = allowsCutEnd };
    }

    // Returns the next whole packet, or null at the end of the stream. The stream must hold only packets.
    public async Task<byte[]?> ReadAsync()
    {
        while (true)
        {
            ScanResult result = _scanner.Scan(_buffer.AsSpan(0, _count));
            if (result.Status == ScanStatus.Packet)
            {
                byte[] packet = _buffer[..result.Length];
                _count -= result.Length;
                _buffer.AsSpan(result.Length, _count).CopyTo(_buffer);
                return packet;
            }

            Assert.Equal(ScanStatus.NeedMoreData, result.Status);
            int read = await Socket.ReceiveAsync(_buffer.AsMemory(_count), TestContext.Current.CancellationToken).Soon();
            if (read == 0)
            {
                Assert.True(_count == 0 || AllowsCutEnd);
                return null;
            }

            _count += read;
        }
    }

    public async Task<List<byte[]>> ReadToEndAsync(Func<Task>? afterEach = null)
    {
        var packets = new List<byte[]>();
        while (await ReadAsync() is { } packet)
        {
            packets.Add(packet);
            if (afterEach is not null)
                await afterEach();
        }

        return packets;
    }

    public void Reset()
    {
        Socket.LingerState = new LingerOption(enable: true, seconds: 0);
        Socket.Dispose();
    }

    public void Dispose() => Socket.Dispose();
}
