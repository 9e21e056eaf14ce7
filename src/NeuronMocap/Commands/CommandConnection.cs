using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using System.Runtime.ExceptionServices;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Commands;

// One TCP connection of a client, used by its thread; only Close may be called from others.
//
// A reply carries nothing that says which request it answers, apart from the command's number where the server repeats it. So a reply that comes late,
// or twice, must never find a later request waiting that it could be the answer to. Three rules see to it, and a new connection is cheap:
// a connection carries each command at most once; it is given up after anything but a plain exchange, be it a failure, a byte too many or a
// number that was not repeated, or need not be; and it is given up when something lies there before a request is sent.
internal sealed class CommandConnection(NeuronCommandOptions options, LinkOptions link, Func<string, IPAddress[]> resolve)
{
    private readonly object _lock = new();
    private readonly HashSet<CommandChannelId> _asked = [];
    private readonly CommandPacketReader _reader = new(options.MaxReplySize);
    private Socket? _socket;
    private bool _isClosed;

    // Whether the server has said anything since it was last asked.
    public bool HasHeard { get; private set; }

    // Readable without a byte: the server has closed it, or it was reset.
    public bool IsLeft
    {
        get
        {
            try
            {
                return !_isClosed && _socket!.Poll(0, SelectMode.SelectRead) && _socket.Available == 0;
            }
            catch (Exception exception) when (SocketErrors.IsExpected(exception))
            {
                return !_isClosed;
            }
        }
    }

    public bool CanAsk(CommandChannelId? id)
    {
        if (_isClosed || (id is { } command && _asked.Contains(command)))
            return false;

        try
        {
            // The end of the connection is readable, too.
            return _reader.IsEmpty && !_socket!.Poll(0, SelectMode.SelectRead);
        }
        catch (Exception exception) when (SocketErrors.IsExpected(exception))
        {
            return false;
        }
    }

    public void Open()
    {
        IPAddress[] addresses = Resolve();
        ConnectionReason telling = ConnectionReason.HostNotFound;
        Exception? cause = null;
        foreach (IPAddress address in addresses)
        {
            (ConnectionReason reason, Exception? exception) = Connect(new IPEndPoint(address, options.Port));
            if (reason == ConnectionReason.None)
                return;
            if (reason == ConnectionReason.Requested)
                break;
            if (cause is null || TcpLink.Weight(reason) > TcpLink.Weight(telling))
                (telling, cause) = (reason, exception);
        }

        throw CommandMessages.NotConnected(telling, link, cause);
    }

    // Throws a NeuronCommandException; the caller then closes the connection.
    public void Ask(CommandRequest request)
    {
        CommandChannelId id = request.Id!.Value;
        _asked.Add(id);
        HasHeard = false;
        var watch = Stopwatch.StartNew();
        bool isPlain;
        try
        {
            if (_asked.Count == 1 && _socket!.Available > 0)
                throw CommandMessages.SpokeFirst(link.Target);

            Send(request.Encode(), watch);
            isPlain = Receive(request, id, watch);
        }
        catch (SocketException exception) when (exception.SocketErrorCode is SocketError.TimedOut or SocketError.WouldBlock)
        {
            throw TimedOut();
        }
        catch (Exception exception) when (SocketErrors.IsExpected(exception))
        {
            throw CommandMessages.Closed(link.Target, isIncomplete: !_reader.IsEmpty, exception);
        }

        if (!isPlain)
            Close();
    }

    public void Close()
    {
        lock (_lock)
        {
            _isClosed = true;
            _socket?.Dispose();
            Monitor.PulseAll(_lock);
        }
    }

    private IPAddress[] Resolve()
    {
        if (IPAddress.TryParse(options.Host, out IPAddress? address))
            return [address];

        // No runtime can interrupt the system's resolver; a thread that waits for it longer than a connection may is left to its end.
        IPAddress[] addresses = [];
        try
        {
            if (!Run("NeuronMocap command resolve", () => addresses = resolve(options.Host)))
                throw CommandMessages.ResolverTimedOut(link);
        }
        catch (Exception exception) when (exception is SocketException or ArgumentException)
        {
            ConnectionReason reason = exception is SocketException error ? SocketErrors.ToReason(error.SocketErrorCode) : ConnectionReason.HostNotFound;
            throw CommandMessages.NotConnected(reason, link, exception);
        }

        return addresses;
    }

    private (ConnectionReason Reason, Exception? Cause) Connect(IPEndPoint remote)
    {
        Socket? socket = null;
        try
        {
            socket = new Socket(remote.AddressFamily, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
            if (!Adopt(socket))
                return (ConnectionReason.Requested, null);

            if (!Run("NeuronMocap command connect", () => TcpConnect.Run(socket, remote)))
            {
                socket.Dispose();
                return (ConnectionReason.TimedOut, new TimeoutException());
            }

            if (!TcpLink.IsOwnEcho(socket, remote))
                return (ConnectionReason.None, null);

            socket.Dispose();
            return (ConnectionReason.Refused, new SocketException((int)SocketError.ConnectionRefused));
        }
        catch (Exception exception) when (SocketErrors.IsExpected(exception))
        {
            socket?.Dispose();
            SocketError error = (exception as SocketException)?.SocketErrorCode ?? SocketError.SocketError;
            return (SocketErrors.ToReason(error), exception);
        }
    }

    private bool Adopt(Socket socket)
    {
        lock (_lock)
        {
            if (!_isClosed)
            {
                _socket = socket;
                return true;
            }
        }

        socket.Dispose();
        return false;
    }

    // Waits for what the system cannot be made to give up, on a thread that is left to its end when the time is up, or when the connection is closed
    // from outside: false then. No task is waited for, because on Mono that takes a thread of the pool, which may have none.
    private bool Run(string name, Action action)
    {
        bool isDone = false;
        Exception? failure = null;
        _ = DedicatedThread.RunAsync(name, Attempt);

        var watch = Stopwatch.StartNew();
        lock (_lock)
        {
            TimeSpan remaining = options.ConnectTimeout;
            while (!isDone && !_isClosed && remaining > TimeSpan.Zero)
            {
                Monitor.Wait(_lock, remaining);
                remaining = options.ConnectTimeout - watch.Elapsed;
            }

            if (failure is not null)
                ExceptionDispatchInfo.Capture(failure).Throw();

            return isDone;
        }

        void Attempt()
        {
            Exception? caught = null;
            try
            {
                action();
            }
            catch (Exception exception)
            {
                caught = exception;
            }

            lock (_lock)
            {
                (isDone, failure) = (true, caught);
                Monitor.PulseAll(_lock);
            }
        }
    }

    private void Send(byte[] packet, Stopwatch watch)
    {
        for (int sent = 0; sent < packet.Length;)
        {
            _socket!.SendTimeout = Remaining(watch);
            sent += _socket.Send(packet, sent, packet.Length - sent, SocketFlags.None);
        }
    }

    // True when nothing came but the reply, with the number of the request.
    private bool Receive(CommandRequest request, CommandChannelId asked, Stopwatch watch)
    {
        bool isPlain = true;
        while (true)
        {
            CommandChannelHeader header;
            ReadOnlySpan<byte> payload;
            while (!_reader.TryRead(out header, out payload))
                Fill(watch);

            if (!_reader.IsAllowed(header))
                throw CommandMessages.WrongSize(link.Target, header.PayloadSize, options);

            bool isAnswer = options.AcceptAnyReplyId || header.CommandId == (int)asked || header.CommandId == 0;
            isPlain &= header.CommandId == (int)asked && !options.AcceptAnyReplyId;
            if (isAnswer)
            {
                request.Complete(payload);
                return isPlain && _reader.IsEmpty && _reader.Skipped == 0;
            }

            // The late answer to something else is passed over.
            if (!Enum.IsDefined(typeof(CommandChannelId), (int)header.CommandId))
                throw CommandMessages.WrongId(link.Target, asked, header.CommandId);
        }
    }

    private void Fill(Stopwatch watch)
    {
        ArraySegment<byte> room = _reader.GetRoom();
        _socket!.ReceiveTimeout = Remaining(watch);
        int count = _socket.Receive(room.Array!, room.Offset, room.Count, SocketFlags.None);
        if (count == 0)
            throw CommandMessages.Closed(link.Target, isIncomplete: !_reader.IsEmpty, cause: null);

        HasHeard = true;
        _reader.Add(count);
    }

    // At least a millisecond: to a socket, zero is for ever.
    private int Remaining(Stopwatch watch)
    {
        double remaining = options.Timeout.TotalMilliseconds - watch.Elapsed.TotalMilliseconds;
        return remaining > 0 ? (int)Math.Ceiling(remaining) : throw TimedOut();
    }

    private NeuronCommandException TimedOut() =>
        CommandMessages.TimedOut(link.Target, options, _reader.Skipped, isIncomplete: !_reader.IsEmpty);
}
