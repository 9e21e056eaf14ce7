using System.Net.Sockets;
using NeuronMocap.Commands;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Faults;
using NeuronMocap.Transport;

namespace NeuronMocap.Server.Clients;

// One client of the command channel. Its own thread reads requests and answers them one after the other.
internal sealed class CommandSession : ICommandSession
{
    // Real requests have at most four bytes of parameters.
    private const int MaxParameters = 1024;

    // A client that does not read its answers is disconnected.
    public static readonly TimeSpan SendTimeout = TimeSpan.FromSeconds(5);

    private readonly ClientTransport _transport;
    private readonly CommandAnswers _answers;
    private readonly CommandReplyQuirks _quirks;
    private readonly IdleClock _idle;
    private readonly ManualResetEventSlim _stop;
    private readonly Action<ICommandSession> _ended;
    private readonly Worker _worker;
    private readonly CommandPacketReader _reader = new(MaxParameters);
    private bool _isAsking;

    // The server owns the event stop, which ends a delay. ended is called once, on the session's thread. An exception of a source ends the session.
    public CommandSession(
        ClientTransport transport,
        CommandAnswers answers,
        CommandServerOptions options,
        Func<long> getTimestamp,
        ManualResetEventSlim stop,
        Action<ICommandSession> ended,
        FaultReport report)
    {
        _transport = transport;
        _answers = answers;
        _quirks = options.Quirks;
        _idle = new IdleClock(options.IdleTimeout, getTimestamp);
        _stop = stop;
        _ended = ended;
        _worker = new Worker("NeuronMocap commands", Run, report);
    }

    // Thread-safe.
    public IdleClock Idle => _idle;

    // Thread-safe. The client has closed its side and no answer is left to send, so the session is about to end.
    public bool IsLeft => _idle.Elapsed is not null && _transport.IsLeft;

    public Worker Start()
    {
        _worker.Start();
        return _worker;
    }

    public void Dispose() => _transport.Dispose();

    private void Run()
    {
        try
        {
            Serve();
        }
        catch (Exception exception) when (!_isAsking && (SocketErrors.IsExpected(exception) || exception is OutOfMemoryException))
        {
            // The client disconnected or the server closed the socket. Both are ordinary ends of a connection. Or memory ran out.
        }
        finally
        {
            Dispose();
            _ended(this);
        }
    }

    private void Serve()
    {
        while (true)
        {
            CommandChannelHeader request;
            ReadOnlySpan<byte> parameters;
            while (!_reader.TryRead(out request, out parameters))
            {
                // Bytes that are not a request do not extend the time.
                if (_idle.GetRest() is not { } rest)
                    return;

                int count = _transport.Receive(_reader.GetRoom(), rest);
                if (count == 0)
                    return;

                _reader.Add(count);
            }

            // After an impossible size, the start of the next request is unknown.
            _idle.Stop();
            if (!_reader.IsAllowed(request) || !Answer(request, parameters))
                return;

            _idle.Restart();
        }
    }

    // Returns false when the connection must be closed.
    private bool Answer(in CommandChannelHeader request, ReadOnlySpan<byte> parameters)
    {
        _isAsking = true;
        byte[] payload = _answers.GetPayload(request.CommandId, parameters);
        _isAsking = false;
        byte[] reply = Encode(_quirks.ReplyId ?? request.CommandId, payload);
        if (_quirks.CloseInstead || (_quirks.Delay > TimeSpan.Zero && _stop.Wait(_quirks.Delay)))
            return false;

        if (_quirks.Unsolicited)
        {
            CommandChannelId other = request.CommandId == (int)CommandChannelId.RotationOrder ? CommandChannelId.ZeroOutAll : CommandChannelId.RotationOrder;
            Send(Encode((int)other, [0, 0, 0, 0]));
        }

        for (int i = 0; i < _quirks.Answers; i++)
            Send(reply);

        return true;
    }

    private byte[] Encode(int id, byte[] payload)
    {
        if (_quirks.PayloadSize is { } size)
            Array.Resize(ref payload, size);

        byte[] packet = new byte[CommandChannelHeader.Size + payload.Length];
        new CommandChannelHeader
        {
            CommandType = _quirks.CommandType,
            CommandId = (ushort)id,
            PayloadSize = _quirks.AnnouncedSize ?? payload.Length,
            Reserved = _quirks.Reserved,
        }.Write(packet);
        payload.CopyTo(packet, CommandChannelHeader.Size);
        return packet;
    }

    private void Send(byte[] packet)
    {
        int piece = _quirks.Fragment ?? packet.Length;
        for (int sent = 0; sent < packet.Length;)
        {
            SocketError error = _transport.TrySend(packet, sent, Math.Min(piece, packet.Length - sent), out int count);
            if (error != SocketError.Success)
                throw new SocketException((int)error);

            sent += count;
        }
    }
}
