using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

/// <summary>Accepts connections on its own thread until it is disposed.</summary>
internal sealed class ClientListener : IDisposable
{
    private const int Backlog = 512;

    // The delay in milliseconds after an error that lasts, such as no more file handles. It is long enough not to spin and short enough for a client.
    private const int RetryDelay = 50;

    private readonly Socket _socket;
    private readonly Action<Socket> _accepted;
    private volatile bool _isDisposed;

    /// <summary>Opens the port.</summary>
    /// <param name="endPoint">Address and port. Port 0 takes any free port.</param>
    /// <param name="accepted">Called on the listener's thread. It owns the socket, unless it throws.</param>
    /// <param name="report">Receives the exceptions that <paramref name="accepted"/> throws. The listener continues.</param>
    /// <exception cref="SocketException">The address or the port is not available.</exception>
    public ClientListener(IPEndPoint endPoint, Action<Socket> accepted, FaultReport report)
    {
        _accepted = accepted;
        _socket = new Socket(endPoint.AddressFamily, SocketType.Stream, ProtocolType.Tcp);
        try
        {
            if (endPoint.Address.Equals(IPAddress.IPv6Any))
                _socket.DualMode = true;
            _socket.Bind(endPoint);
            _socket.Listen(Backlog);
            LocalEndPoint = (IPEndPoint)_socket.LocalEndPoint!;
        }
        catch
        {
            _socket.Dispose();
            throw;
        }

        Worker = new Worker("NeuronMocap listener", Run, report);
    }

    public IPEndPoint LocalEndPoint { get; }

    public Worker Worker { get; }

    public void Dispose()
    {
        _isDisposed = true;
        _socket.Dispose();
    }

    private void Run()
    {
        while (!_isDisposed)
        {
            try
            {
                Socket client = _socket.Accept();
                if (!Worker.Attempt(() => _accepted(client)))
                    client.Dispose();
            }
            catch (ObjectDisposedException)
            {
                return;
            }
            catch (Exception exception) when (exception is SocketException or OutOfMemoryException)
            {
                // The client disconnected before it was accepted, or the system is temporarily out of handles or memory.
                if (!_isDisposed)
                    Thread.Sleep(RetryDelay);
            }
        }
    }
}
