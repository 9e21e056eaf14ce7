using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Recording;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>
/// The input as a raw dump of a stream. Every byte is played once and in order, at times that do not decrease. A jump to any time plays the rest of
/// the dump.
/// </summary>
internal sealed class DumpTarget
{
    private readonly byte[] _played = new byte[FuzzInput.MaxLength];

    public void Run(FuzzInput input)
    {
        var file = new MemoryStream(input.Segment.Array!, input.Segment.Offset, input.Segment.Count, writable: false);
        using RecordedEventSource source = RawDumpSource.Open("dump", file, new PlaybackOptions());
        input.Digest.Add(source.Duration.Ticks);
        WrongResultException.ThrowUnless(Play(source, input).SequenceEqual(input.Bytes), "What is played is not the dump.");

        bool isStart = source.Seek(source.Duration * (input.Random.Below(1000) / 1000.0));
        ReadOnlySpan<byte> rest = Play(source, input);
        WrongResultException.ThrowUnless(
            rest.Length > 0 && input.Bytes.EndsWith(rest) && (!isStart || rest.Length == input.Bytes.Length), "The jump missed.");
    }

    private ReadOnlySpan<byte> Play(RecordedEventSource source, FuzzInput input)
    {
        int length = 0;
        TimeSpan last = TimeSpan.Zero;
        RecordedEvent arrival;
        while ((arrival = source.Read()).Kind != RecordedEventKind.End)
        {
            WrongResultException.ThrowUnless(arrival.Time >= last && arrival.Time <= source.Duration, "A time is out of order.");
            WrongResultException.ThrowUnless(arrival.Bytes.Count <= _played.Length - length, "More is played than there is.");
            arrival.Bytes.AsSpan().CopyTo(_played.AsSpan(length));
            length += arrival.Bytes.Count;
            last = arrival.Time;
            input.Found++;
            input.Digest.Add(arrival.Time.Ticks);
            input.Digest.Add((long)arrival.Bytes.Count);
        }

        return _played.AsSpan(0, length);
    }
}
