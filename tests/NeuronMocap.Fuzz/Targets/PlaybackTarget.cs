using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>The input as a recording that is played. Its frames come in order, and playback continues after a jump to any time.</summary>
internal sealed class PlaybackTarget
{
    private const int Jumps = 4;

    private readonly byte[] _file = new byte[FuzzInput.MaxLength];

    public void Run(FuzzInput input)
    {
        input.Bytes.CopyTo(_file);
        if (input.Random.Below(8) > 0)
            RecordingChecksums.Mend(_file.AsSpan(0, input.Bytes.Length));

        ReadFrames(input);
        Jump(input);
    }

    private void ReadFrames(FuzzInput input)
    {
        using var reader = new RecordedFrameReader(Open(input), new PlaybackOptions());
        TimeSpan last = TimeSpan.Zero;
        while (reader.Read())
        {
            WrongResultException.ThrowUnless(reader.Time >= last && reader.Time <= reader.Duration, "A time is out of order.");
            last = reader.Time;
            input.Found++;
            input.Digest.Add((long)reader.Connection);
            input.Digest.Add((long)reader.Frame.AvatarIndex);
            input.Digest.Add(reader.Frame.AvatarName);
        }

        input.Digest.Add(reader.GetStatistics().BytesSkipped);
        foreach (SkipReason reason in Enum.GetValues<SkipReason>())
            input.Digest.Add(reader.GetSkipped(reason));
    }

    private void Jump(FuzzInput input)
    {
        using RecordedStreamSource source = Open(input);
        for (int i = 0; i < Jumps; i++)
        {
            TimeSpan to = source.Duration * (input.Random.Below(1001) / 1000.0);
            source.Seek(to);
            TimeSpan last = TimeSpan.Zero;
            RecordedEvent arrival;
            while ((arrival = source.Read()).Kind != RecordedEventKind.End)
            {
                WrongResultException.ThrowUnless(arrival.Time >= last && arrival.Time <= source.Duration, "A time is out of order after a jump.");
                WrongResultException.ThrowUnless(arrival.Kind != RecordedEventKind.Bytes || arrival.Time >= to, "The jump missed.");
                last = arrival.Time;
                input.Digest.Add((long)arrival.Kind);
            }
        }
    }

    private RecordedStreamSource Open(FuzzInput input) =>
        new("recording", RecordingReader.Open(new MemoryStream(_file, 0, input.Bytes.Length, writable: false)));
}
