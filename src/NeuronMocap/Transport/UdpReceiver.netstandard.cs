using System.Diagnostics;
using System.Diagnostics.CodeAnalysis;
using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

// On this target framework, a blocking ReceiveFrom allocates the sender's address for every datagram; the event-driven form reuses its own. It runs on the
// pool threads on which the system completes it.
internal sealed class UdpReceiver : IDisposable
{
    private const int MaxDatagram = 65_536;

    private readonly Socket _socket;
    private readonly UdpSenders _senders;
    private readonly SenderEndPoint _sender;
    private readonly SocketAsyncEventArgs _operation = new();
    private readonly ReceiveGate _lock;
    private readonly TaskCompletionSource<bool> _completion = new();

    private UdpReceiver(Socket socket, UdpSenders senders, ReceiveGate gate)
    {
        _socket = socket;
        _senders = senders;
        _lock = gate;
        _sender = new SenderEndPoint(socket.LocalEndPoint!);
        _operation.SetBuffer(new byte[MaxDatagram], 0, MaxDatagram);
        _operation.Completed += (_, _) => Receive(completed: true);
    }

    public const bool HasThreads = false;

    // Throws when the gate or the socket is closed, or when the socket fails.
    [SuppressMessage("Style", "IDE0060", Justification = "The member is that of the other target.")]
    public static async Task ReceiveAsync(Socket socket, UdpSenders senders, ReceiveGate gate, ReceiveThread thread)
    {
        using var receiver = new UdpReceiver(socket, senders, gate);
        receiver.Receive(completed: false);
        await gate.UntilClosedAsync(receiver._completion.Task).ConfigureAwait(false);
    }

    public void Dispose() => _operation.Dispose();

    // Runs until an operation is pending, whose completion calls this method again, or until the socket is closed.
    private void Receive(bool completed)
    {
        try
        {
            do
            {
                if (completed)
                    Deliver();

                _operation.RemoteEndPoint = _sender;
                completed = !_socket.ReceiveFromAsync(_operation);
            }
            while (completed);
        }
        catch (Exception exception)
        {
            _completion.TrySetException(exception);
        }
    }

    private void Deliver()
    {
        if (_operation.SocketError != SocketError.Success)
            throw new SocketException((int)_operation.SocketError);

        // Some runtimes replace the end point by their own, instead of filling this one.
        SocketAddress address = _operation.RemoteEndPoint is SenderEndPoint sender ? sender.Address : _operation.RemoteEndPoint!.Serialize();
        if (_lock.TryEnter())
            _senders.Push(address, new ArraySegment<byte>(_operation.Buffer!, 0, _operation.BytesTransferred), Stopwatch.GetTimestamp());
        if (!_lock.TryLeave())
            throw new OperationCanceledException();
    }

    // Keeps the sender's address in the object that the runtime wrote it to. Other end points make a new object.
    private sealed class SenderEndPoint(EndPoint local) : EndPoint
    {
        public SocketAddress Address { get; private set; } = local.Serialize();

        public override AddressFamily AddressFamily => local.AddressFamily;

        public override SocketAddress Serialize() => Address;

        public override EndPoint Create(SocketAddress socketAddress)
        {
            Address = socketAddress;
            return this;
        }
    }
}
