using System.Text.Json.Nodes;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Info;

/// <summary>The sections about the container of a recording: its time, connections and damage.</summary>
internal static class RecordingSections
{
    private const int LongestValue = 120;

    // A file can hold millions of connections and senders. A list that long is useless.
    private const int MaxEvents = 1000;

    public static void Add(InfoReport report, string path, long size, IProgress<double> progress, CancellationToken cancellationToken)
    {
        using RecordingReader reader = RecordingReader.Open(path);
        InfoSection recording = report.Section("recording", "Recording");
        InfoSection connections = report.Section("connections", "Connections");
        InfoSection damage = report.Section("damage", "Damage");
        (long pieces, long bytes, long lost) = ReadEntries(reader, connections, progress, cancellationToken);

        recording.Add("bytes", string.Empty, null, size);
        recording.Add("start", "recorded", Quantity.Format($"{reader.StartTime:yyyy-MM-dd HH:mm:ss} UTC"), JsonValue.Create(reader.StartTime.UtcDateTime));
        recording.Add("seconds", "duration", Quantity.Format($"{reader.Duration.TotalSeconds:0.000} s"), reader.Duration.TotalSeconds);
        recording.Add("payloadBytes", "received", Quantity.Format($"{Quantity.Bytes(bytes)} in {Quantity.Count(pieces, "piece")}, kept in {Quantity.Bytes(size)}"), bytes);
        recording.Add("pieces", string.Empty, null, pieces).Add("lostBytes", string.Empty, null, lost);
        recording.Add("complete", "closed", reader.IsComplete ? "yes" : "no: the recording program was killed, could not write, or is still running", reader.IsComplete);
        if (reader.FileNumber > 1)
            recording.Add("fileNumber", "file", Quantity.Format($"number {reader.FileNumber} of recording {reader.RecordingId}"), reader.FileNumber);

        var metadata = new JsonObject();
        foreach ((string key, string value) in reader.Metadata.Values)
        {
            metadata[key] = value;
            string line = value.ReplaceLineEndings(" ");
            recording.Add(string.Empty, key, line.Length <= LongestValue ? line : line[..LongestValue] + "…", (JsonNode?)null);
        }

        recording.Add("metadata", string.Empty, null, metadata);
        if (lost > 0)
            damage.Remark("lostBytes", $"{Quantity.Bytes(lost)} arrived faster than they could be written");
        foreach (RecordingProblem problem in reader.Problems)
        {
            damage.Item(
                Quantity.Format($"at byte {problem.Offset:#,0}, {Quantity.Count(problem.Length, "byte")}: {problem.Description}"),
                new JsonObject { ["offset"] = problem.Offset, ["length"] = problem.Length, ["text"] = problem.Description });
        }
    }

    private static (long Pieces, long Bytes, long Lost) ReadEntries(
        RecordingReader reader, InfoSection connections, IProgress<double> progress, CancellationToken cancellationToken)
    {
        (long pieces, long bytes, long lost) = (0, 0, 0);
        long events = 0;
        while (reader.TryRead(out RecordingEntry entry))
        {
            cancellationToken.ThrowIfCancellationRequested();
            progress.Report(reader.Duration > TimeSpan.Zero ? entry.Time / reader.Duration : 0);
            switch (entry.Kind)
            {
                case RecordingEntryKind.Bytes:
                    pieces++;
                    bytes += entry.Bytes.Length;
                    break;
                case RecordingEntryKind.BytesLost:
                    lost += entry.LostBytes;
                    break;
                case RecordingEntryKind.ConnectionOpened:
                    RecordedConnection opened = entry.Opened!;
                    if (++events <= MaxEvents)
                        Add(connections, entry, "opened", $"{opened.Transport.ToString().ToUpperInvariant()} {NameOf(opened)}");
                    break;
                case RecordingEntryKind.SenderAdded:
                    if (++events <= MaxEvents)
                        Add(connections, entry, "sender", $"datagrams of {entry.Text}");
                    break;
                case RecordingEntryKind.ConnectionClosed:
                    if (++events <= MaxEvents)
                        Add(connections, entry, "closed", $"closed: {entry.Text}");
                    break;
                default:
                    break;
            }
        }

        if (events > MaxEvents)
            connections.Remark("more", Quantity.Format($"and {events - MaxEvents:#,0} more, which are not listed"));

        return (pieces, bytes, lost);
    }

    private static string NameOf(RecordedConnection connection) =>
        (connection.Remote, connection.Local) switch
        {
            ("", "") => "without addresses: it was made from a file",
            ("", var local) => $"on {local}",
            (var remote, "") => $"from {remote}",
            (var remote, var local) => $"from {remote} to {local}",
        };

    private static void Add(InfoSection section, in RecordingEntry entry, string code, string text) => section.Item(
        Quantity.Format($"{entry.Time.TotalSeconds,10:0.000} s  connection {entry.Connection}: {text}"),
        new JsonObject
        {
            ["connection"] = entry.Connection,
            ["seconds"] = Math.Round(entry.Time.TotalSeconds, 7),
            ["code"] = code,
            ["text"] = text,
        });
}
