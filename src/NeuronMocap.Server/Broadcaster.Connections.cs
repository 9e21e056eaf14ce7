using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Clients;

namespace NeuronMocap.Server;

// Serves recipients from the first byte to the last. Runs on the threads of the listener, the pacer and the recipients, and under the gate.
public sealed partial class Broadcaster
{
    private void Open()
    {
        var senders = new List<NetworkRecipient>(_options.UdpDestinations.Count * _streams.Length);
        var listeners = new List<ClientListener>(_streams.Length);
        try
        {
            foreach (BroadcastStream stream in _streams)
            {
                foreach (IPEndPoint destination in _options.UdpDestinations)
                    senders.Add(CreateSender(stream, stream.IsBeside ? new IPEndPoint(destination.Address, _options.CalculationPort!.Value) : destination));
                if (_options.Port is int port)
                    listeners.Add(Listen(stream, stream.IsBeside ? _options.CalculationPort!.Value : port));
            }
        }
        catch
        {
            senders.ForEach(sender => sender.Discard());
            listeners.ForEach(listener => listener.Dispose());
            throw;
        }

        _recipients.AddRange(senders);
        for (int i = 0; i < listeners.Count; i++)
            _streams[i].Listen(listeners[i]);

        LocalEndPoint = _streams[0].Listener?.LocalEndPoint;
        CalculationEndPoint = _streams.FirstOrDefault(static stream => stream.IsBeside)?.Listener?.LocalEndPoint;
    }

    private UdpRecipient CreateSender(BroadcastStream stream, IPEndPoint destination)
    {
        Socket socket = ConnectUdp(destination);
        try
        {
            return new UdpRecipient(
                socket, destination, stream, stream.CreateFeed(isSingle: _plan is null), _options.Fragment, OnRecipientEnded, _report);
        }
        catch
        {
            socket.Dispose();
            throw;
        }
    }

    private static Socket ConnectUdp(IPEndPoint destination)
    {
        try
        {
            return UdpRecipient.Connect(destination);
        }
        catch (SocketException exception)
        {
            throw BroadcasterException.CannotSend(destination, exception);
        }
    }

    private ClientListener Listen(BroadcastStream stream, int port)
    {
        var endPoint = new IPEndPoint(_options.BindAddress, port);
        try
        {
            return new ClientListener(endPoint, socket => OnAccepted(stream, socket), _report);
        }
        catch (SocketException exception)
        {
            string setting = stream.IsBeside ? nameof(BroadcasterOptions.CalculationPort) : nameof(BroadcasterOptions.Port);
            throw BroadcasterException.CannotListen(endPoint, setting, exception);
        }
    }

    // Frames exist from here on.
    private void Begin()
    {
        if (_hasBegun)
            return;

        _hasBegun = true;
        try
        {
            foreach (UdpRecipient sender in _recipients.OfType<UdpRecipient>())
                Launch(sender.Worker);
            if (_forwarder is not null)
                Launch(_forwarder.Worker);
            if (_pacer is null)
                return;

            _pacer.Open();
            Launch(_pacer.Worker);
        }
        catch (Exception exception)
        {
            // Usually the system cannot create another thread. The broadcast cannot start, so Completion must fail with the reason.
            Close(exception);
        }
    }

    private void Launch(Worker worker)
    {
        StartWorker(worker);
        _workers.Add(worker);
    }

    private int CountClients(BroadcastStream stream) => ClientsOf(stream).Count;

    private List<ClientSession> ClientsOf(BroadcastStream stream) => [.. _recipients.OfType<ClientSession>().Where(client => client.Stream == stream)];

    // A session notices that its client has left when it sends the next frame. While a relay gets no frames, such sessions would fill the port.
    private bool HasRoom(BroadcastStream stream)
    {
        List<ClientSession> clients = ClientsOf(stream).FindAll(static client => !client.IsDisposed);
        if (clients.Count < _options.MaxClients)
            return true;

        // One place is enough. A client that has only closed its sending side may still read.
        ClientSession? left = clients.Find(static client => client.IsLeft);
        left?.Leave();
        return left is not null;
    }

    private void OnAccepted(BroadcastStream stream, Socket socket)
    {
        lock (_lock)
        {
            if (!TryServe(stream, () => new SocketTransport(socket, _options.ClientTimeout, ClientSession.SendBufferSize), OnRecipientEnded))
                socket.Dispose();
        }
    }

    // Takes the client's place in the log before the first frame is made. Returns false if the client is not served; the caller then ends its connection.
    private bool TryServe(BroadcastStream stream, Func<ClientTransport> open, Action<Recipient, Exception?> ended)
    {
        if (_hasEnded || !HasRoom(stream))
        {
            _refused += _hasEnded ? 0 : 1;
            return false;
        }

        FrameFeed? feed = null;
        try
        {
            feed = stream.CreateFeed(isSingle: false);
            var session = new ClientSession(open(), stream, feed, _options, ended, _report);
            Launch(session.Worker);
            _recipients.Add(session);
            _accepted++;
        }
        catch (Exception exception)
        {
            // The client reset the connection before it was served, the system cannot create a thread, or the recording's file is gone.
            _refused++;
            feed?.Close();
            if (exception is not (SocketException or OutOfMemoryException or IOException or UnauthorizedAccessException or NeuronException))
                _report.Report(exception);
            return false;
        }

        OnServed(stream);
        return true;
    }

    // Without a listener, a stream has no clients of its own to wait for.
    private void OnServed(BroadcastStream stream)
    {
        stream.HasAccepted = true;
        if (_streams.All(static each => each.HasAccepted || each.Listener is null))
            Begin();
    }

    private void OnRecipientEnded(Recipient recipient, Exception? error)
    {
        lock (_lock)
        {
            _recipients.Remove(recipient);
            _departed = _departed.Add(recipient.Counters);
            _forwarder?.Forget(recipient);
            recipient.Stream.HasServed |= recipient.HadAll && (recipient is not UdpRecipient || recipient.Stream.Listener is null);
            Monitor.PulseAll(_lock);

            // The pacer ends a paced broadcast.
            bool isOver = _pacer is null && _recipients.Count == 0 && _streams.All(static stream => stream.HasServed || !stream.AwaitsClients);
            if (isOver || error is not null)
                Close(error);
        }
    }

    // The pacer's thread has no other work left. It makes sure that clients end in time.
    private void OnPacerEnded(Exception? error)
    {
        lock (_lock)
        {
            if (error is null)
            {
                foreach (BroadcastStream stream in _streams)
                {
                    stream.Listener?.Dispose();
                    stream.Log!.Complete();
                }

                WaitForRecipients(_options.CloseTimeout);
            }

            Close(error);
        }
    }

    private void WaitForRecipients(TimeSpan timeout)
    {
        var watch = Stopwatch.StartNew();
        TimeSpan remaining = timeout;
        while (_recipients.Count > 0 && !_hasEnded && remaining > TimeSpan.Zero)
        {
            Monitor.Wait(_lock, remaining);
            remaining = timeout - watch.Elapsed;
        }
    }

    private void Close(Exception? error)
    {
        if (_hasEnded)
            return;

        _hasEnded = true;
        _pacer?.Stop();
        _forwarder?.Stop();
        foreach (BroadcastStream stream in _streams)
        {
            stream.Listener?.Dispose();
            stream.Log?.Abort();
        }

        foreach (Recipient recipient in _recipients)
            recipient.Stop();

        Monitor.PulseAll(_lock);
        if (error is null)
            _completion.TrySetResult(true);
        else
            _completion.TrySetException(error);
    }
}
