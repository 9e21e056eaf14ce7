using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Tests.Network;

// A port that answers no connection attempt. Its listener accepts nothing and its queue is full, so the system drops further attempts.
internal sealed class BlackHole : IDisposable
{
    private readonly Socket _listener = new(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
    private readonly List<Socket> _queued = [];

    public BlackHole()
    {
        _listener.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        _listener.Listen(backlog: 1);

        // Attempts that do not connect found the queue full. It needs two of them, made without another thread, because a single one may merely be
        // late.
        for (int unanswered = 0; unanswered < 2;)
        {
            if (!TryConnect())
                unanswered++;
        }
    }

    public int Port => ((IPEndPoint)_listener.LocalEndPoint!).Port;

    public void Dispose()
    {
        _listener.Dispose();
        foreach (Socket socket in _queued)
            socket.Dispose();
    }

    private bool TryConnect()
    {
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { Blocking = false };
        _queued.Add(socket);
        try
        {
            socket.Connect(IPAddress.Loopback, Port);
        }
        catch (SocketException exception) when (exception.SocketErrorCode is SocketError.WouldBlock or SocketError.InProgress)
        {
            // The answer is still to come.
        }

        return socket.Poll(TimeSpan.FromMilliseconds(100), SelectMode.SelectWrite);
    }
}
