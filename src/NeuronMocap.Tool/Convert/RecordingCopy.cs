using NeuronMocap.Recording;

namespace NeuronMocap.Tool.Convert;

/// <summary>Copies a recording entry by entry, with all bytes as they were received. Bytes that do not form packets are included.</summary>
internal sealed class RecordingCopy(RecordingReader reader, TimeRange range, IProgress<double> progress, CancellationToken cancellationToken)
{
    // The open connections of the copy. After a damaged place a recording repeats which connections are open, and the damage may have hidden an end.
    private readonly Dictionary<int, RecordedConnection> _open = [];
    private readonly HashSet<(int Connection, int Sender)> _senders = [];

    /// <summary>Number of pieces of bytes that were copied.</summary>
    public long Pieces { get; private set; }

    /// <summary>Copies to another recording. Its times start at the start of the range.</summary>
    public void WriteTo(RecordingWriter writer)
    {
        while (TryRead(out RecordingEntry entry))
        {
            TimeSpan time = entry.Time > range.Start ? entry.Time - range.Start : TimeSpan.Zero;
            switch (entry.Kind)
            {
                case RecordingEntryKind.ConnectionOpened:
                    Open(writer, time, entry.Opened! with { WasOpen = entry.Opened!.WasOpen || entry.Time < range.Start });
                    break;
                case RecordingEntryKind.Metadata:
                    writer.SetMetadata(time, entry.Key!, entry.Text!);
                    break;
                case RecordingEntryKind.Bytes:
                    writer.WriteBytes(time, entry.Connection, entry.Bytes, entry.Sender);
                    Pieces++;
                    break;
                case RecordingEntryKind.BytesLost:
                    writer.WriteLoss(time, entry.Connection, entry.LostPieces, entry.LostBytes);
                    break;
                case RecordingEntryKind.Damaged:
                    WriteDamage(writer, time, entry.LostBytes);
                    break;
                default:
                    if (_open.ContainsKey(entry.Connection))
                        CopyState(writer, time, entry);
                    break;
            }
        }
    }

    // The copy has no damaged place. Without a loss, a packet before that place and bytes after it would become one frame. Any connection may have lost
    // bytes; their number is told once.
    private void WriteDamage(RecordingWriter writer, TimeSpan time, long bytes)
    {
        foreach (int connection in _open.Keys)
        {
            writer.WriteLoss(time, connection, pieces: 1, bytes);
            bytes = 0;
        }
    }

    /// <summary>Copies only the bytes.</summary>
    /// <exception cref="NeuronException">The bytes came from several senders over UDP, and their datagrams would be mixed.</exception>
    public void WriteTo(Stream output)
    {
        var datagramSenders = new HashSet<(int Connection, int Sender)>();
        var isUdp = new HashSet<int>();
        while (TryRead(out RecordingEntry entry))
        {
            if (entry.Opened is { Transport: TransportKind.Udp })
                isUdp.Add(entry.Connection);
            if (entry.Kind != RecordingEntryKind.Bytes)
                continue;
            if (isUdp.Contains(entry.Connection) && datagramSenders.Add((entry.Connection, entry.Sender)) && datagramSenders.Count > 1)
                throw new NeuronException("The recording has datagrams of several senders, which raw bytes cannot keep separate; .nmrec can.");

            output.Write(entry.Bytes);
            Pieces++;
        }
    }

    private void Open(RecordingWriter writer, TimeSpan time, RecordedConnection connection)
    {
        if (_open.TryGetValue(connection.Number, out RecordedConnection? open))
        {
            if (open with { WasOpen = connection.WasOpen } == connection)
                return;

            Close(writer, time, connection.Number, "The end is in a damaged place.");
        }

        _open.Add(connection.Number, connection);
        writer.OpenConnection(time, connection);
    }

    private void Close(RecordingWriter writer, TimeSpan time, int connection, string reason)
    {
        _open.Remove(connection);
        _senders.RemoveWhere(sender => sender.Connection == connection);
        writer.CloseConnection(time, connection, reason);
    }

    // Copies the state of an open connection.
    private void CopyState(RecordingWriter writer, TimeSpan time, in RecordingEntry entry)
    {
        var sender = (entry.Connection, entry.Sender);
        switch (entry.Kind)
        {
            case RecordingEntryKind.SenderAdded when _senders.Add(sender):
                writer.AddSender(time, entry.Connection, entry.Sender, entry.Text!);
                break;
            case RecordingEntryKind.SenderRemoved when _senders.Remove(sender):
                writer.RemoveSender(time, entry.Connection, entry.Sender);
                break;
            case RecordingEntryKind.ConnectionClosed:
                Close(writer, time, entry.Connection, entry.Text!);
                break;
            default:
                break;
        }
    }

    // Connections that are open and known at the start of the range count as well.
    private bool TryRead(out RecordingEntry entry)
    {
        while (reader.TryRead(out entry))
        {
            cancellationToken.ThrowIfCancellationRequested();
            progress.Report(reader.Duration > TimeSpan.Zero ? entry.Time / reader.Duration : 0);
            bool isTraffic = entry.Kind is RecordingEntryKind.Bytes or RecordingEntryKind.BytesLost or RecordingEntryKind.Damaged;
            if (range.Contains(entry.Time) || (!isTraffic && entry.Time < range.Start))
                return true;
        }

        return false;
    }
}
