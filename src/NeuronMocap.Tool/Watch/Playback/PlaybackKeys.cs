using NeuronMocap.Recording;

namespace NeuronMocap.Tool.Watch.Playback;

/// <summary>The keys of the live view that control a playback.</summary>
internal static class PlaybackKeys
{
    private const double Slowest = 0.01;
    private const double Fastest = 100;

    private static readonly TimeSpan Jump = TimeSpan.FromSeconds(5);

    /// <summary>The keys and their effects.</summary>
    public static (string Name, string Meaning)[] Entries { get; } =
    [
        ("space", "pause or resume the playback"),
        (". ,", "pause, and step one frame forward or back"),
        ("← →", "jump 5 s back or forward"),
        ("+ -", "play twice or half as fast"),
        ("0", "play at the speed of the recording"),
    ];

    /// <summary>Handles a key.</summary>
    /// <param name="player">The playback.</param>
    /// <param name="key">The key.</param>
    /// <returns>Whether the key controls a playback.</returns>
    public static bool TryHandle(RecordingPlayer player, ConsoleKeyInfo key)
    {
        switch (key)
        {
            case { KeyChar: ' ' } when player.IsPaused:
                player.Resume();
                return true;
            case { KeyChar: ' ' }:
                player.Pause();
                return true;
            case { KeyChar: '.' }:
                player.Step();
                return true;
            case { KeyChar: ',' }:
                player.StepBack();
                return true;
            case { Key: ConsoleKey.LeftArrow }:
                player.Seek(player.Position - Jump);
                return true;
            case { Key: ConsoleKey.RightArrow }:
                player.Seek(player.Position + Jump);
                return true;
            case { KeyChar: '+' or '=' }:
                player.Speed = Math.Clamp(player.Speed * 2, Slowest, Fastest);
                return true;
            case { KeyChar: '-' }:
                player.Speed = Math.Clamp(player.Speed / 2, Slowest, Fastest);
                return true;
            case { KeyChar: '0' }:
                player.Speed = 1;
                return true;
            default:
                return false;
        }
    }

    /// <summary>Gets short descriptions of the keys, for the line below the view.</summary>
    /// <param name="isPaused">Whether the playback is paused.</param>
    public static (string Name, string Meaning)[] Hints(bool isPaused) =>
        [("space", isPaused ? "resume" : "pause"), (", .", "step"), ("← →", "5 s"), ("+ - 0", "speed")];

    /// <summary>Formats "0:12.3 of 1:03.2, 2x", or "0:12.345 of 1:03.2, paused". The additional digits show a step of one frame.</summary>
    /// <param name="player">The playback.</param>
    public static string Describe(RecordingPlayer player)
    {
        double speed = player.Speed;
        string pace = double.IsPositiveInfinity(speed) ? ", max" : speed == 1 ? string.Empty : FormattableString.Invariant($", {speed:0.###}x");
        string pass = player.Pass > 1 ? FormattableString.Invariant($", pass {player.Pass}") : string.Empty;
        bool isPaused = player.IsPaused;
        string position = isPaused ? FormatExactly(player.Position) : Format(player.Position);
        return $"{position} of {Format(player.Duration)}{pace}{pass}{(isPaused ? ", paused" : string.Empty)}";
    }

    private static string Format(TimeSpan time) => FormattableString.Invariant($"{(int)time.TotalMinutes}:{time.Seconds:00}.{time.Milliseconds / 100}");

    private static string FormatExactly(TimeSpan time) => FormattableString.Invariant($"{(int)time.TotalMinutes}:{time.Seconds:00}.{time.Milliseconds:000}");
}
