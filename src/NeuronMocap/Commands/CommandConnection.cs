using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using System.Runtime.ExceptionServices;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Commands;

// One TCP connection of a client. Only the client's thread uses it, except for Close, which any thread may call.
//
// A reply does not say which request it answers; it has only the command's number, if the server repeats it. A late or repeated reply must therefore never
// reach a later request that it could seem to answer. A new connection is cheap, so three rules ensure this:
// - A connection carries each command at most once.
// - The client closes a connection after anything but a plain exchange: a failure, an extra byte, or a number that is not repeated or not checked.
// - The client closes a connection that holds unread bytes before it sends a request.
internal sealed class CommandConnection(NeuronCommandOptions options, LinkOptions link, Func<string, IPAddress[]> resolve)
{
    private readonly object _lock = new();
    private readonly HashSet<CommandChannelId> _asked = [];
    private readonly CommandPacketReader _reader = new(options.MaxReplySize);
    private Socket? _socket;
    private bool _isClosed;

    // Whether the server has sent anything since the last request.
    public bool HasHeard { get; private set; }

    // True if the connection is readable but has no bytes: the server has closed or reset it.
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
            // The end of the connection makes it readable too.
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

        // No runtime can interrupt the system's resolver. If a thread waits for it longer than the connect timeout, it is left running.
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
        // Systems report several errors for this, and some of those errors have other meanings too.
        if (options.LocalAddress is { } own && own.AddressFamily != remote.AddressFamily)
            return (ConnectionReason.AddressUnavailable, new SocketException((int)SocketError.AddressNotAvailable));

        Socket? socket = null;
        try
        {
            socket = new Socket(remote.AddressFamily, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
            if (!Adopt(socket))
                return (ConnectionReason.Requested, null);

            if (options.LocalAddress is { } local)
                socket.Bind(new IPEndPoint(local, 0));

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

    // Runs a system call that cannot be cancelled, on a thread of its own. Returns false if the time is up, or if the connection is closed from outside;
    // the thread is then left running. The method does not wait for a task, because on Mono that takes a pool thread, and the pool may have none.
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

    // Returns true if the server sent only the reply, with the number of the request.
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

            // A late answer to another request is skipped.
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

    // At least one millisecond, because a socket interprets zero as no timeout.
    private int Remaining(Stopwatch watch)
    {
        double remaining = options.Timeout.TotalMilliseconds - watch.Elapsed.TotalMilliseconds;
        return remaining > 0 ? (int)Math.Ceiling(remaining) : throw TimedOut();
    }

    private NeuronCommandException TimedOut() =>
        CommandMessages.TimedOut(link.Target, options, _reader.Skipped, isIncomplete: !_reader.IsEmpty);
}
