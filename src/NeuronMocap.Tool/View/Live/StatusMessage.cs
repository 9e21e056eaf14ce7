namespace NeuronMocap.Tool.View.Live;

/// <summary>The state of the stream: once a second, and when it changes.</summary>
/// <param name="State">"created", "connecting", "connected", "receiving", "silent", "waiting" or "stopped".</param>
/// <param name="Words">The state, or the problem, in a few words.</param>
/// <param name="Advice">What to check, in sentences; empty if nothing is wrong.</param>
/// <param name="Address">The other end of the connection, or the source.</param>
/// <param name="Performers">Figures of each performer.</param>
/// <param name="BytesPerSecond">Bytes that arrive from the source.</param>
/// <param name="Reconnects">How often the connection was made again.</param>
internal sealed record StatusMessage(
    string State, string Words, string Advice, string Address, IReadOnlyList<PerformerFigures> Performers, double BytesPerSecond, long Reconnects)
{
    public string Type { get; } = "status";

    /// <summary>Milliseconds until the next attempt to connect; null if none is planned.</summary>
    public double? RetryIn { get; init; }

    /// <summary>Poses that pages did not get, because they or their network were too slow.</summary>
    public long Dropped { get; init; }
}

/// <summary>The figures of a performer.</summary>
/// <param name="Key">The performer.</param>
/// <param name="Fps">Frames that arrive per second.</param>
/// <param name="Latency">Mean milliseconds from the receipt of a frame to its sending; null if no page shows motion.</param>
/// <param name="Jitter">Milliseconds by which the intervals between frames vary.</param>
/// <param name="Lost">Frames that the network lost, by their numbers.</param>
/// <param name="Dropped">Frames that arrived too late, after a newer one.</param>
internal sealed record PerformerFigures(string Key, double Fps, double? Latency, double Jitter, long Lost, long Dropped);
