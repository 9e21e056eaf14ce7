using System.Net;
using System.Net.Sockets;
using System.Text;

namespace NeuronMocap.Recording;

// Writes the pieces in the ring to the files, until it is stopped or writing fails. Runs on one thread.
internal sealed class RecordingThread(PieceRing ring, RecordingFiles files, TimeSpan flushInterval, RecordingClock clock)
{
    // The time is read only now and then.
    private const int PiecesPerCheck = 64;

    // The open connections, two at most.
    private readonly List<(int Number, bool IsCalculation, SenderTable Senders)> _open = [];
    private readonly object _lock = new();
    private readonly Dictionary<string, string> _metadata = new(StringComparer.Ordinal);
    private (long Pieces, long Bytes) _lossReported;
    private TimeSpan _time;
    private bool _isDirty;
    private long _flushed;
    private volatile bool _hasMetadata;
    private volatile bool _stopping;

    // Any thread. The value is written with the next piece.
    public void SetMetadata(string key, string value)
    {
        lock (_lock)
            _metadata[key] = value;

        _hasMetadata = true;
    }

    // Any thread. Pieces that are in the ring are still written.
    public void Stop()
    {
        _stopping = true;
        ring.Wake();
    }

    // If a file cannot be written, the exception of the system reaches the caller. The total loss is read at the end, when it no longer changes.
    public void Run(Func<(long Pieces, long Bytes)> getLoss)
    {
        _flushed = RecordingClock.Now;
        while (!_stopping)
        {
            WriteMetadata();
            WritePieces();
            TimeSpan left = UntilFlush();
            if (left <= TimeSpan.Zero)
                Flush();
            else
                ring.Wait(left);
        }

        WriteMetadata();
        WritePieces();
        (long pieces, long bytes) = getLoss();
        if (pieces > _lossReported.Pieces)
            WriteLoss(clock.TimeOf(RecordingClock.Now), _open.Count > 0 ? _open[0].Number : 0, pieces - _lossReported.Pieces, bytes - _lossReported.Bytes);

        Flush();
    }

    private TimeSpan UntilFlush() => flushInterval - RecordingClock.Between(_flushed, RecordingClock.Now);

    private void Flush()
    {
        _flushed = RecordingClock.Now;
        if (_isDirty)
            files.Flush();

        _isDirty = false;
    }

    private void WriteMetadata()
    {
        if (!_hasMetadata)
            return;

        lock (_lock)
        {
            // Not the current time: pieces that arrived earlier may still wait in the ring.
            RecordingWriter writer = files.Prepare(_time, 0, out TimeSpan time);
            foreach ((string key, string value) in _metadata)
            {
                // A value beyond the limits of the metadata is not recorded.
                if (writer.Metadata.TryWith(key, value, out _, out _))
                    writer.SetMetadata(time, key, value);
            }

            _metadata.Clear();
            _hasMetadata = false;
            _isDirty = true;
        }
    }

    // On a busy computer, or with much data, the ring is not empty for a long time. Values of the metadata and flushes do not wait for that.
    private void WritePieces()
    {
        for (int count = 1; ring.TryPeek(out PieceRecord record); count++)
        {
            WriteMetadata();
            Write(record, ring.Peek(record));
            ring.Release(record);
            _isDirty = true;
            if (count % PiecesPerCheck == 0 && UntilFlush() <= TimeSpan.Zero)
                Flush();
        }
    }

    private void Write(in PieceRecord record, ReadOnlySpan<byte> content)
    {
        ReadOnlySpan<byte> text = content[..record.TextLength];
        ReadOnlySpan<byte> bytes = content[record.TextLength..];
        TimeSpan time = clock.TimeOf(record.Timestamp);
        int connection = record.Connection;
        _time = time;
        switch (record.Kind)
        {
            case PieceKind.Opened:
                Open(record, time, Encoding.UTF8.GetString(text));
                break;
            case PieceKind.Bytes:
                WriteBytes(record, time, text, bytes);
                break;
            case PieceKind.Lost:
                WriteLoss(time, record.Connection, record.LostPieces, record.LostBytes);
                break;
            default:
                Close(_open.FindIndex(open => open.Number == connection), time, Encoding.UTF8.GetString(text));
                break;
        }
    }

    private void Open(in PieceRecord record, TimeSpan time, string endPoints)
    {
        // A reader has one connection of each kind at a time. If the previous one is still listed, there was no room to report its end.
        bool isCalculation = record.IsCalculation;
        Close(_open.FindIndex(open => open.IsCalculation == isCalculation), time, nameof(ConnectionReason.None));
        _open.Add((record.Connection, isCalculation, new SenderTable()));
        string[] parts = endPoints.Split('\n');
        var connection = new RecordedConnection(record.Connection, record.IsDatagrams ? TransportKind.Udp : TransportKind.Tcp, parts[0], parts[1])
        {
            WasOpen = record.WasOpen,
            IsCalculation = isCalculation,
        };
        files.Prepare(time, endPoints.Length, out TimeSpan timeInFile).OpenConnection(timeInFile, connection);
    }

    private void Close(int place, TimeSpan time, string reason)
    {
        if (place < 0)
            return;

        files.Prepare(time, reason.Length, out TimeSpan timeInFile).CloseConnection(timeInFile, _open[place].Number, reason);
        _open.RemoveAt(place);
    }

    private void WriteBytes(in PieceRecord record, TimeSpan time, ReadOnlySpan<byte> sender, ReadOnlySpan<byte> bytes)
    {
        RecordingWriter writer = files.Prepare(time, bytes.Length, out TimeSpan timeInFile);
        if (sender.Length > 0 && SendersOf(record.Connection).IsNew(record.Sender, out int? forgotten))
        {
            if (forgotten is { } old)
                writer.RemoveSender(timeInFile, record.Connection, old);

            writer.AddSender(timeInFile, record.Connection, record.Sender, Describe(sender));
        }

        writer.WriteBytes(timeInFile, record.Connection, bytes, record.Sender);
    }

    private SenderTable SendersOf(int connection)
    {
        foreach ((int number, _, SenderTable senders) in _open)
        {
            if (number == connection)
                return senders;
        }

        throw new InvalidOperationException($"Connection {connection} is not open.");
    }

    private void WriteLoss(TimeSpan time, int connection, long pieces, long bytes)
    {
        _lossReported = (_lossReported.Pieces + pieces, _lossReported.Bytes + bytes);
        files.Prepare(time, 0, out TimeSpan timeInFile).WriteLoss(timeInFile, connection, pieces, bytes);
    }

    private static string Describe(ReadOnlySpan<byte> sender)
    {
        // The bytes contain the address family.
        var address = new SocketAddress(AddressFamily.InterNetwork, sender.Length);
        for (int i = 0; i < sender.Length; i++)
            address[i] = sender[i];

        IPAddress any = address.Family == AddressFamily.InterNetworkV6 ? IPAddress.IPv6Any : IPAddress.Any;
        return new IPEndPoint(any, 0).Create(address).ToString()!;
    }
}
