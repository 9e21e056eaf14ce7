using System.Text;
using NeuronMocap.Protocol;

namespace NeuronMocap.Recording;

// What a recorder has told of one connection into its ring. Where there was no room, it is told before the next piece that finds some. Producer only.
internal sealed class RecordedLink(StreamConnection connection, bool isTold)
{
    private bool _isTold = isTold;
    private long _untoldPieces;
    private long _untoldBytes;

    public StreamConnection Connection => connection;

    public static bool TryTellOpened(PieceRing ring, StreamConnection connection, bool wasOpen, long timestamp)
    {
        var record = new PieceRecord
        {
            Kind = PieceKind.Opened,
            Connection = connection.Number,
            IsDatagrams = connection.IsDatagrams,
            IsCalculation = connection.IsCalculation,
            WasOpen = wasOpen,
            Timestamp = timestamp,
        };
        return ring.TryWrite(record, Encoding.UTF8.GetBytes($"{connection.Local}\n{connection.Remote}"), []);
    }

    public void Lose(int bytes)
    {
        _untoldPieces++;
        _untoldBytes += bytes;
    }

    // Before a piece: that its connection opened, if there was no room for it then, and what was lost.
    public bool TryTellWhatIsUntold(PieceRing ring, long timestamp)
    {
        if (!_isTold)
            _isTold = TryTellOpened(ring, connection, wasOpen: true, timestamp);

        return _isTold && TryTellLoss(ring, timestamp);
    }

    public void TellClosed(PieceRing ring, string reason, long timestamp)
    {
        if (!_isTold)
            return;

        // Both have room kept for them. Where even that is full, the next connection's opening says that this one is gone.
        _ = TryTellLoss(ring, timestamp);
        var record = new PieceRecord { Kind = PieceKind.Closed, Connection = connection.Number, Timestamp = timestamp };
        _ = ring.TryWrite(record, Encoding.UTF8.GetBytes(reason), []);
    }

    private bool TryTellLoss(PieceRing ring, long timestamp)
    {
        if (_untoldPieces == 0)
            return true;

        var record = new PieceRecord
        {
            Kind = PieceKind.Lost,
            Connection = connection.Number,
            LostPieces = _untoldPieces,
            LostBytes = _untoldBytes,
            Timestamp = timestamp,
        };
        if (!ring.TryWrite(record, [], []))
            return false;

        _untoldPieces = 0;
        _untoldBytes = 0;
        return true;
    }
}
