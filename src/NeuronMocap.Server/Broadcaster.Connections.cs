using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Clients;

namespace NeuronMocap.Server;

// Who is served, from the first byte to the last: on the threads of the listener, the pacer and the recipients, and under the gate.
public sealed partial class Broadcaster
{
    private void Open()
    {
        var senders = new List<Recipient>(_options.UdpDestinations.Count);
        try
        {
            foreach (IPEndPoint destination in _options.UdpDestinations)
                senders.Add(new UdpSender(ConnectUdp(destination), destination, _content, CreateFeed(isSingle: _recording is not null), _options.Fragment, OnRecipientEnded));
            if (_options.Port is int port)
                _listener = Listen(new IPEndPoint(_options.BindAddress, port));
        }
        catch
        {
            senders.ForEach(sender => sender.Dispose());
            throw;
        }

        _recipients.AddRange(senders);
        LocalEndPoint = _listener?.LocalEndPoint;
    }

    private static Socket ConnectUdp(IPEndPoint destination)
    {
        try
        {
            return UdpSender.Connect(destination);
        }
        catch (SocketException exception)
        {
            throw BroadcasterException.CannotSend(destination, exception);
        }
    }

    private ClientListener Listen(IPEndPoint endPoint)
    {
        try
        {
            return new ClientListener(endPoint, OnAccepted);
        }
        catch (SocketException exception)
        {
            throw BroadcasterException.CannotListen(endPoint, exception);
        }
    }

    private FrameFeed CreateFeed(bool isSingle) => _log is null ? _content.CreateFeed(isSingle) : new LiveFeed(_log, isSingle);

    // From here on there are frames.
    private void Begin()
    {
        if (_hasBegun)
            return;

        _hasBegun = true;
        try
        {
            foreach (Recipient sender in _recipients.Where(recipient => recipient is UdpSender))
                StartWorker(sender.Worker);
            if (_pacer is not null)
                StartWorker(_pacer.Worker);
        }
        catch (OutOfMemoryException exception)
        {
            // The system has no thread left: there can be no broadcast, and whoever waits for its end shall know why.
            Close(exception);
        }
    }

    private int CountClients() => _recipients.Count(recipient => recipient is TcpClientSession);

    private void OnAccepted(Socket socket)
    {
        lock (_gate)
        {
            if (_isOver || CountClients() >= _options.MaxClients)
            {
                _refused += _isOver ? 0 : 1;
                socket.Dispose();
                return;
            }

            if (TryServe(socket))
                Begin();
        }
    }

    // The client has its place in the log before the first frame is made.
    private bool TryServe(Socket socket)
    {
        try
        {
            var session = new TcpClientSession(
                socket, _content, CreateFeed(isSingle: false), _options, _options.AnswerDataCommands ? _replies : null, OnRecipientEnded);
            StartWorker(session.Worker);
            _recipients.Add(session);
            _accepted++;
            return true;
        }
        catch (Exception exception) when (exception is SocketException or OutOfMemoryException or IOException or UnauthorizedAccessException or NeuronException)
        {
            // It was reset before it was greeted, or the system has no thread left for it, or the recording's file is gone.
            _refused++;
            socket.Dispose();
            return false;
        }
    }

    private void OnRecipientEnded(Recipient recipient, Exception? error)
    {
        lock (_gate)
        {
            _recipients.Remove(recipient);
            _departed = _departed.Add(recipient.Counters);
            _hasServed |= recipient is TcpClientSession && recipient.HadAll;
            Monitor.PulseAll(_gate);

            // A paced broadcast is ended by its pacer.
            bool isOver = _pacer is null && _recipients.Count == 0 && (_listener is null || _hasServed);
            if (isOver || error is not null)
                Close(error);
        }
    }

    // The pacer's thread, which has nothing else to do any more, sees to it that clients end in time.
    private void OnPacerEnded(Exception? error)
    {
        lock (_gate)
        {
            if (error is null)
            {
                _listener?.Dispose();
                _log!.Complete();
                WaitForRecipients(_options.CloseTimeout);
            }

            Close(error);
        }
    }

    private void WaitForRecipients(TimeSpan timeout)
    {
        var watch = Stopwatch.StartNew();
        TimeSpan remaining = timeout;
        while (_recipients.Count > 0 && !_isOver && remaining > TimeSpan.Zero)
        {
            Monitor.Wait(_gate, remaining);
            remaining = timeout - watch.Elapsed;
        }
    }

    private void Close(Exception? error)
    {
        if (_isOver)
            return;

        _isOver = true;
        _listener?.Dispose();
        _pacer?.Stop();
        _log?.Abort();
        _recipients.ForEach(recipient => recipient.Dispose());
        Monitor.PulseAll(_gate);
        if (error is null)
            _completion.TrySetResult(true);
        else
            _completion.TrySetException(error);
    }
}
