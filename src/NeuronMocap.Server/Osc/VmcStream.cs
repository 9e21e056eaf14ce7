using System.Net.Sockets;
using NeuronMocap.Transport;

namespace NeuronMocap.Server.Osc;

/// <summary>The motion packets that a decoder makes of the datagrams of a socket. Reads block.</summary>
internal sealed class VmcStream(Socket socket, VmcDecoder decoder, Action<long> addRejected) : ReadOnlyStream
{
    // Not every runtime ends a blocking receive when its socket closes.
    private const int PollMicroseconds = 100_000;

    private readonly byte[] _datagram = new byte[65_536];
    private volatile bool _isClosed;

    public override int Read(byte[] buffer, int offset, int count)
    {
        while (decoder.Length == 0)
        {
            if (!TryReceive())
                return 0;
        }

        return decoder.Read(buffer.AsSpan(offset, count));
    }

    protected override void Dispose(bool disposing)
    {
        _isClosed = true;
        if (disposing)
            socket.Dispose();

        base.Dispose(disposing);
    }

    // Returns false at the end. A datagram may hold no end of a frame.
    private bool TryReceive()
    {
        try
        {
            while (!_isClosed && !socket.Poll(PollMicroseconds, SelectMode.SelectRead))
            {
            }

            if (_isClosed)
                return false;

            int length = socket.Receive(_datagram, 0, _datagram.Length, SocketFlags.None, out SocketError error);
            if (error == SocketError.Success)
            {
                long before = decoder.Rejected;
                decoder.Receive(_datagram.AsSpan(0, length));
                addRejected(decoder.Rejected - before);
            }
            else if (error != SocketError.ConnectionReset)
            {
                // Windows reports a reset when an earlier datagram was refused. The reader opens the port again after any other error.
                throw new SocketException((int)error);
            }

            return !_isClosed;
        }
        catch (Exception exception) when (_isClosed && exception is ObjectDisposedException or SocketException)
        {
            return false;
        }
    }
}
