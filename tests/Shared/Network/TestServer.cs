using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Tests.Network;

// A TCP server that a test controls step by step.
internal sealed partial class TestServer : IDisposable
{
    private readonly TcpListener _listener;

    public TestServer()
        : this(IPAddress.Loopback)
    {
    }

    public TestServer(IPAddress address, int port = 0)
    {
        _listener = port > 0 ? Listen(address, port) : ListenAnywhere(address);
    }

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    // A busy machine delays threads for seconds, so connections that should not be silent, or abandoned by a stop, get more time.
    public NeuronReaderOptions Options(bool reconnect = false)
    {
        var options = new NeuronReaderOptions
        {
            Port = Port,
            ConnectTimeout = Limits.Unexpected,
            SilenceTimeout = Limits.Unexpected,
            Reconnect = { Enabled = reconnect, InitialDelay = TimeSpan.FromMilliseconds(1), MaxDelay = TimeSpan.FromMilliseconds(5) },
        };
        SetStopTimeout(options);
        return options;
    }

    public async Task<TestConnection> AcceptAsync() => new(await _listener.AcceptSocketAsync(TestContext.Current.CancellationToken).AsTask().Soon());

    // For servers that wait until the test is over.
    public async Task<TestConnection> AcceptAsync(CancellationToken cancellationToken)
    {
        try
        {
            return new(await _listener.AcceptSocketAsync(cancellationToken));
        }
        catch (Exception exception) when (cancellationToken.IsCancellationRequested && exception is SocketException or InvalidOperationException)
        {
            throw new OperationCanceledException(cancellationToken);
        }
    }

    public void Dispose() => _listener.Dispose();

    // Not on a port that the system assigns: while a closed server's port must refuse connections, or waits for the next server, the system could
    // assign it to another test.
    private static TcpListener ListenAnywhere(IPAddress address)
    {
        while (true)
        {
            try
            {
                return Listen(address, FreePort.Candidate());
            }
            catch (SocketException exception) when (exception.SocketErrorCode == SocketError.AddressAlreadyInUse)
            {
                // Another program uses the port. Tries the next one.
            }
        }
    }

    private static TcpListener Listen(IPAddress address, int port)
    {
        var listener = new TcpListener(address, port);
        listener.Start();
        return listener;
    }

    // Only some of the test projects can access it.
    static partial void SetStopTimeout(NeuronReaderOptions options);
}

internal sealed class TestConnection : IDisposable
{
    public TestConnection(Socket socket)
    {
        Socket = socket;
        Socket.NoDelay = true;
    }

    public Socket Socket { get; }

    public async Task SendAsync(ReadOnlyMemory<byte> bytes)
    {
        while (bytes.Length > 0)
            bytes = bytes[await Socket.SendAsync(bytes, SocketFlags.None).AsTask().Soon()..];
    }

    public async Task SendPiecesAsync(byte[] bytes, int size)
    {
        for (int start = 0; start < bytes.Length; start += size)
            await SendAsync(bytes.AsMemory(start, Math.Min(size, bytes.Length - start)));
    }

    // A graceful end: everything sent before arrives.
    public void Close()
    {
        Socket.Shutdown(SocketShutdown.Send);
        Socket.Dispose();
    }

    // An abortive end.
    public void Reset()
    {
        Socket.LingerState = new LingerOption(enable: true, seconds: 0);
        Socket.Dispose();
    }

    public void Dispose() => Socket.Dispose();
}
