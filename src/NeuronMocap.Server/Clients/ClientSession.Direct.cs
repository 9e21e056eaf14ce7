using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

// Sending on the thread that publishes, while this session's thread waits in ReadFeed. FrameLog orders both threads.
internal sealed partial class ClientSession : IDirectRecipient
{
    // The rest of a unit that Take has sent in part.
    private readonly byte[] _rest;
    private int _restLength;

    bool IDirectRecipient.IsReady => _restLength == 0;

    // An error is left to the session's thread, which gets the same one.
    int IDirectRecipient.Take(UnitBatch units, int packets, int first)
    {
        int sent;
        try
        {
            SocketError error = _transport.TrySendNow(units.Bytes, 0, units.EndOf(units.Count - 1), out sent);
            if (sent == 0 || error is not (SocketError.Success or SocketError.WouldBlock))
                return 0;
        }
        catch (ObjectDisposedException)
        {
            return 0;
        }

        int taken = 0;
        while (taken < units.Count && units.StartOf(taken) < sent)
            taken++;

        // Once a part of a unit is sent, the client must get all of it. The log may overwrite the unit before this session's thread continues.
        int end = units.EndOf(taken - 1);
        _restLength = end - sent;
        units.Bytes.AsSpan(sent, _restLength).CopyTo(_rest);
        if (_restLength == 0)
        {
            Mark(_sent + end, new FrameBatch(end, taken * packets, first));
        }
        else
        {
            int start = units.StartOf(taken - 1);
            Mark(_sent + start, new FrameBatch(start, (taken - 1) * packets, first));
            Mark(_sent + end, new FrameBatch(end - start, packets, first));
        }

        CountSent(sent);
        CountWritten();
        return taken;
    }

    // Runs on the session's thread.
    private bool WriteRest()
    {
        for (int offset = 0; offset < _restLength;)
        {
            if (!TrySend(_rest, offset, _restLength - offset, out int sent))
                return false;

            offset += sent;
        }

        _restLength = 0;
        return true;
    }
}
