namespace NeuronMocap.Tool.Output;

/// <summary>What has gone to a destination so far, for a line of --json.</summary>
/// <param name="Destination">The destination with its real address.</param>
/// <param name="Unit">Plural word for what is counted.</param>
/// <param name="State">"ok", "idle", "waiting", "dropping", "refused", "unmatched" or "failed".</param>
/// <param name="PerSecond">Units sent per second, lately.</param>
/// <param name="Sent">Number of units that were sent or written.</param>
/// <param name="Dropped">Number of units that were dropped.</param>
internal sealed record FlowFigures(string Destination, string Unit, string State, double PerSecond, long Sent, long Dropped)
{
    /// <summary>Number of clients; null if there cannot be any.</summary>
    public int? Clients { get; init; }

    /// <summary>Bytes that were sent or written; null if they are not counted.</summary>
    public long? Bytes { get; init; }

    /// <summary>Why nothing more can be sent; null if it can.</summary>
    public string? Failure { get; init; }

    /// <summary>Number of units that were left out on request; null if none can be.</summary>
    public long? Skipped { get; init; }
}
