using Microsoft.Extensions.Logging;
using NeuronMocap.Telemetry;

namespace NeuronMocap;

/// <content>What only the .NET build offers.</content>
public sealed partial class NeuronReaderOptions
{
    /// <summary>
    /// Gets a line for every change of the connection's state, and at most one every 10 s for lost and dropped frames, skipped bytes and
    /// failed handlers; category "NeuronMocap.NeuronReader", event ids as in <see cref="ReaderEventId"/>. Null, the default, for no log.
    /// </summary>
    public ILoggerFactory? LoggerFactory { get; set; }

    internal Action<ReaderEvent>? CreateLog() => LoggerFactory is { } factory ? new ReaderLogger(factory).Write : null;
}
