namespace NeuronMocap;

/// <summary>Determines when a reader reconnects after a connection fails or ends.</summary>
/// <remarks>
/// The delays double from <see cref="InitialDelay"/> to <see cref="MaxDelay"/>. Each delay is shortened at random by up to a half, so many clients of one
/// server do not return at the same moment. After a connection that delivered frames, the delays start again.
/// </remarks>
public sealed class ReconnectPolicy
{
    /// <summary>Whether to reconnect. The default is true.</summary>
    public bool Enabled { get; set; } = true;

    /// <summary>First delay; more than zero. The default is 250 ms.</summary>
    public TimeSpan InitialDelay { get; set; } = TimeSpan.FromMilliseconds(250);

    /// <summary>Longest delay; at least <see cref="InitialDelay"/>, at most a day. The default is 5 s.</summary>
    public TimeSpan MaxDelay { get; set; } = TimeSpan.FromSeconds(5);

    // For a playback, whose next connection is established when it was in the recording.
    internal static ReconnectPolicy AtOnce => new() { InitialDelay = TimeSpan.Zero, MaxDelay = TimeSpan.Zero };

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

    // failures: number of attempts without a frame since the last attempt with frames; 0 after an attempt with frames. jitter: 0 to 1.
    internal TimeSpan GetDelay(int failures, double jitter)
    {
        double doubled = InitialDelay.TotalMilliseconds * Math.Pow(2, Math.Min(Math.Max(failures - 1, 0), 30));
        return TimeSpan.FromMilliseconds(Math.Min(doubled, MaxDelay.TotalMilliseconds) * (1 - (jitter / 2)));
    }
}
