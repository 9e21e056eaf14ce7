using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

// Converts random numbers to entries that follow the rules, and knows the expected result of reading them.
internal sealed class EntryScript
{
    private readonly HashSet<int> _open = [];
    private readonly HashSet<(int Connection, int Sender)> _senders = [];
    private readonly Dictionary<string, string> _metadata = [];
    private long _time;

    public List<RecordedEntry> Expected { get; } = [];

    public void Write(RecordingWriter writer, (int Kind, int Delta, int Number, int Size)[] entries)
    {
        foreach ((int kind, int delta, int number, int size) in entries)
        {
            _time += delta;
            Write(writer, kind, number, size);
        }
    }

    private void Write(RecordingWriter writer, int kind, int number, int size)
    {
        TimeSpan time = Recordings.Ticks(_time);
        switch (kind)
        {
            case 0 when _open.Add(number):
                var connection = new RecordedConnection(number, (TransportKind)(size % 2), $"local {size}", "") { WasOpen = size % 3 == 0 };
                writer.OpenConnection(time, connection);
                Expect(RecordingEntryKind.ConnectionOpened, number, opened: connection);
                break;
            case 1 when _open.Remove(number):
                _senders.RemoveWhere(sender => sender.Connection == number);
                writer.CloseConnection(time, number, $"reason {size}");
                Expect(RecordingEntryKind.ConnectionClosed, number, text: $"reason {size}");
                break;
            case 2 when _open.Contains(number) && _senders.Add((number, size)):
                writer.AddSender(time, number, size, "sender");
                Expect(RecordingEntryKind.SenderAdded, number, size, text: "sender");
                break;
            case 3 when _senders.FirstOrDefault(sender => sender.Connection == number) is var found && _senders.Remove(found):
                writer.RemoveSender(time, number, found.Sender);
                Expect(RecordingEntryKind.SenderRemoved, number, found.Sender);
                break;
            case 4:
                writer.WriteLoss(time, number, size, 3L * size);
                Expect(RecordingEntryKind.BytesLost, number, lost: size);
                break;
            case 5 when _metadata.GetValueOrDefault($"key {number}") != $"{size}":
                _metadata[$"key {number}"] = $"{size}";
                writer.SetMetadata(time, $"key {number}", $"{size}");
                Expect(RecordingEntryKind.Metadata, 0, text: $"{size}", key: $"key {number}");
                break;
            case 6:
                writer.Flush();
                break;
            default:
                byte[] piece = [.. Enumerable.Range(0, size).Select(i => (byte)((i * number) + kind))];
                writer.WriteBytes(time, number, piece, size % 5);
                Expect(RecordingEntryKind.Bytes, number, size % 5, piece);
                break;
        }
    }

    private void Expect(
        RecordingEntryKind kind, int connection, int sender = 0, byte[]? bytes = null, RecordedConnection? opened = null, string? text = null, string? key = null, int lost = 0) =>
        Expected.Add(new RecordedEntry(kind, _time, connection, sender, Convert.ToHexString(bytes ?? []), opened, text, key, lost, 3L * lost));
}
