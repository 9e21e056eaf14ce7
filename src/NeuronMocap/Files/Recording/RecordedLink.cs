using System.Text;
using NeuronMocap.Protocol;

namespace NeuronMocap.Recording;

// Tracks what a recorder has written about one connection to its ring. If the ring was full, the missing records are written before the next piece
// that fits. Producer only.
internal sealed class RecordedLink(StreamConnection connection, bool isReported)
{
    private bool _isReported = isReported;
    private long _unreportedPieces;
    private long _unreportedBytes;

    public StreamConnection Connection => connection;

    public static bool TryReportOpened(PieceRing ring, StreamConnection connection, bool wasOpen, long timestamp)
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
        _unreportedPieces++;
        _unreportedBytes += bytes;
    }

    // Called before a piece. Writes the opening of the connection and the losses, if there was no room for them earlier.
    public bool TryReportPending(PieceRing ring, long timestamp)
    {
        if (!_isReported)
            _isReported = TryReportOpened(ring, connection, wasOpen: true, timestamp);

        return _isReported && TryReportLoss(ring, timestamp);
    }

    public void ReportClosed(PieceRing ring, string reason, long timestamp)
    {
        if (!_isReported)
            return;

        // Both records have reserved room. If even that is full, the opening of the next connection implies the end of this one.
        _ = TryReportLoss(ring, timestamp);
        var record = new PieceRecord { Kind = PieceKind.Closed, Connection = connection.Number, Timestamp = timestamp };
        _ = ring.TryWrite(record, Encoding.UTF8.GetBytes(reason), []);
    }

    private bool TryReportLoss(PieceRing ring, long timestamp)
    {
        if (_unreportedPieces == 0)
            return true;

        var record = new PieceRecord
        {
            Kind = PieceKind.Lost,
            Connection = connection.Number,
            LostPieces = _unreportedPieces,
            LostBytes = _unreportedBytes,
            Timestamp = timestamp,
        };
        if (!ring.TryWrite(record, [], []))
            return false;

        _unreportedPieces = 0;
        _unreportedBytes = 0;
        return true;
    }
}
