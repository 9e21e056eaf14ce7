namespace NeuronMocap;

/// <summary>
/// When a reader tries again after a connection failed or ended: after delays that double from <see cref="InitialDelay"/> to
/// <see cref="MaxDelay"/>, each shortened at random by up to a half so that many clients of one server do not return in the same instant.
/// A connection that delivered frames starts the row anew.
/// </summary>
public sealed class ReconnectPolicy
{
    /// <summary>Whether to try again at all. True unless set.</summary>
    public bool Enabled { get; set; } = true;

    /// <summary>First delay. 250 ms unless set; more than zero.</summary>
    public TimeSpan InitialDelay { get; set; } = TimeSpan.FromMilliseconds(250);

    /// <summary>Longest delay. 5 s unless set; at least <see cref="InitialDelay"/>, at most a day.</summary>
    public TimeSpan MaxDelay { get; set; } = TimeSpan.FromSeconds(5);

    internal string? FindFault()
    {
        if (InitialDelay <= TimeSpan.Zero)
            return $"Reconnect.InitialDelay is {InitialDelay}; it must be more than zero.";
        if (MaxDelay < InitialDelay)
            return $"Reconnect.MaxDelay is {MaxDelay}; it must not be less than InitialDelay, {InitialDelay}.";
        if (MaxDelay > TimeSpan.FromDays(1))
            return $"Reconnect.MaxDelay is {MaxDelay}; it must not be more than a day.";

        return null;
    }

    internal ReconnectPolicy Copy() => (ReconnectPolicy)MemberwiseClone();

    // failures: attempts without a frame since the last one with frames; 0 after one with frames. jitter: 0 to 1.
    internal TimeSpan GetDelay(int failures, double jitter)
    {
        double doubled = InitialDelay.TotalMilliseconds * Math.Pow(2, Math.Min(Math.Max(failures - 1, 0), 30));
        return TimeSpan.FromMilliseconds(Math.Min(doubled, MaxDelay.TotalMilliseconds) * (1 - (jitter / 2)));
    }
}
