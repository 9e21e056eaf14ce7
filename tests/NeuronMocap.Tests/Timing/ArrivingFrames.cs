namespace NeuronMocap.Tests.Timing;

/// <summary>Indices and arrival times of the frames of a server.</summary>
internal sealed class ArrivingFrames(double rate, int count)
{
    private readonly Random _random = new(1);

    /// <summary>How late the frames of an opening burst are: they all arrive at this time, in seconds.</summary>
    public double Burst { get; init; }

    /// <summary>How late a frame can be, in seconds. Every delay up to this one is equally frequent.</summary>
    public double Jitter { get; init; }

    /// <summary>Difference of the indices of two frames.</summary>
    public uint Step { get; init; } = 1;

    /// <summary>The part of the frames that are lost, 0 to 1.</summary>
    public double Loss { get; init; }

    /// <summary>How long the server pauses after a third of the frames, in seconds. The index does not count the pause.</summary>
    public double Pause { get; init; }

    /// <summary>How long no frame arrives after two thirds of the frames, in seconds. The index counts.</summary>
    public double Outage { get; init; }

    public bool HasIndex { get; init; } = true;

    public IEnumerable<(uint? Index, TimeSpan Time)> Frames()
    {
        double newest = 0;
        for (int i = 0; i < count; i++)
        {
            double sent = i / rate;
            double pause = i >= count / 3 ? Pause : 0;
            bool isOut = sent >= count * 2 / 3 / rate && sent < (count * 2 / 3 / rate) + Outage;
            newest = Math.Max(newest, Math.Max(sent, Burst) + pause + (_random.NextDouble() * Jitter));
            if (!isOut && _random.NextDouble() >= Loss)
                yield return (HasIndex ? 1000 + ((uint)i * Step) : null, TimeSpan.FromSeconds(10) + TimeSpan.FromTicks((long)Math.Round(newest * TimeSpan.TicksPerSecond)));
        }
    }
}
