using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

// An entry that can be kept and compared.
internal sealed record RecordedEntry(
    RecordingEntryKind Kind, long Time, int Connection, int Sender, string Bytes, RecordedConnection? Opened, string? Text, string? Key, long LostPieces, long LostBytes)
{
    public static List<RecordedEntry> ReadAll(RecordingReader reader)
    {
        var entries = new List<RecordedEntry>();
        while (reader.TryRead(out RecordingEntry entry))
            entries.Add(From(entry));

        return entries;
    }

    public static List<RecordedEntry> ReadAll(byte[] file)
    {
        using RecordingReader reader = RecordingReader.Open(new MemoryStream(file));
        return ReadAll(reader);
    }

    public static RecordedEntry From(in RecordingEntry entry) => new(
        entry.Kind,
        entry.Time.Ticks,
        entry.Connection,
        entry.Sender,
        Convert.ToHexString(entry.Bytes),
        entry.Opened,
        entry.Text,
        entry.Key,
        entry.LostPieces,
        entry.LostBytes);
}
