using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>What has gone to a destination so far.</summary>
/// <param name="Sent">Number of units that were sent or written.</param>
/// <param name="Dropped">Number of units that were dropped because the destination was too slow or not reachable.</param>
internal readonly record struct OutletFigures(long Sent, long Dropped)
{
    /// <summary>Number of clients that are connected; null if there cannot be any.</summary>
    public int? Clients { get; init; }

    /// <summary>Bytes that were sent or written; null if they are not counted.</summary>
    public long? Bytes { get; init; }

    /// <summary>Why nothing more can be sent; null if it can.</summary>
    public string? Failure { get; init; }

    /// <summary>Number of units that were left out on request; null if none can be.</summary>
    public long? Skipped { get; init; }

    /// <summary>What the user may want to know about the last second; null for nothing.</summary>
    public OutletNote? Note { get; init; }
}

/// <summary>What the user may want to know about a destination.</summary>
/// <param name="Code">The state for scripts, as in docs/reference/json.md.</param>
/// <param name="Text">The note for people.</param>
internal sealed record OutletNote(string Code, string Text);

/// <summary>A destination that is being served.</summary>
internal abstract class Outlet : IAsyncDisposable
{
    /// <summary>The destination with its real address, for the user.</summary>
    public abstract string Name { get; }

    /// <summary>The line that announces it to the user and to scripts.</summary>
    public abstract string Announcement { get; }

    /// <summary>Word for one of what is counted.</summary>
    public abstract string Noun { get; }

    /// <summary>Plural word for what is counted.</summary>
    public string Unit => Noun + "s";

    public abstract OutletFigures GetFigures();

    /// <summary>Sends or writes the rest. The reader has ended before.</summary>
    /// <param name="streams">Receives what the user must know on standard error.</param>
    /// <returns>False if something is missing that a file should hold.</returns>
    public abstract Task<bool> FinishAsync(StandardStreams streams);

    public abstract ValueTask DisposeAsync();
}
