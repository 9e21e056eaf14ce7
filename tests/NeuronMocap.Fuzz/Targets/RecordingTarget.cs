using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Recording;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>
/// The input as a recording, mostly with corrected checksums, because otherwise every changed file would fail at the first checksum. Results are in
/// order and within bounds. A second reading from the start gives the same, and a jump to any time ends there.
/// </summary>
internal sealed class RecordingTarget
{
    /// <summary>A block in the file and unpacked, at most 1 MiB each, plus the memory for opening.</summary>
    public const long AllocatedForBlocks = (3 * 1024 * 1024) + (64 * 1024);

    private readonly byte[] _file = new byte[FuzzInput.MaxLength];

    public void Run(FuzzInput input)
    {
        input.Bytes.CopyTo(_file);
        if (input.Random.Below(8) > 0)
            RecordingChecksums.Mend(_file.AsSpan(0, input.Bytes.Length));

        using RecordingReader reader = RecordingReader.Open(new MemoryStream(_file, 0, input.Bytes.Length, writable: false));
        input.Digest.Add(reader.StartTime.Ticks);
        input.Digest.Add(reader.Duration.Ticks);
        foreach ((string key, string value) in reader.Metadata.Values)
        {
            input.Digest.Add(key);
            input.Digest.Add(value);
        }

        (ulong first, long found) = ReadAll(reader, input.Bytes.Length, TimeSpan.Zero);
        input.Found += found;
        input.Digest.Add(first);
        foreach (RecordingProblem problem in reader.Problems)
        {
            bool isInside = problem.Offset >= 64 && problem.Length >= 0 && problem.Offset + problem.Length <= input.Bytes.Length;
            WrongResultException.ThrowUnless(isInside, "A problem lies outside the file.");
            input.Digest.Add(problem.Offset);
        }

        TimeSpan middle = reader.Duration / 2;
        reader.Seek(middle);
        input.Digest.Add(ReadAll(reader, input.Bytes.Length, middle).Digest);
    }

    private static (ulong Digest, long Found) ReadAll(RecordingReader reader, int length, TimeSpan from)
    {
        Digest digest = default;
        long found = 0;
        TimeSpan last = TimeSpan.Zero;
        while (reader.TryRead(out RecordingEntry entry))
        {
            found++;
            WrongResultException.ThrowUnless(entry.Time >= last, "Time goes back.");
            bool isTraffic = entry.Kind is RecordingEntryKind.Bytes or RecordingEntryKind.BytesLost;
            WrongResultException.ThrowUnless(!isTraffic || entry.Time >= from, "The jump missed.");
            WrongResultException.ThrowUnless(
                entry is { Connection: >= 0, Sender: >= 0, LostBytes: >= 0, LostPieces: >= 0 } && entry.Bytes.Length <= 1024 * 1024, "An entry is out of bounds.");
            last = entry.Time;
            digest.Add((long)entry.Kind);
            digest.Add(entry.Time.Ticks);
            digest.Add((long)entry.Connection);
            digest.Add((long)entry.Sender);
            digest.Add(entry.Bytes);
            digest.Add(entry.Text);
            digest.Add(entry.Key);
            digest.Add(entry.Opened?.Local);
        }

        return (digest.Value, found);
    }
}
