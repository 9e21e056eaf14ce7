using Microsoft.Extensions.Logging;
using NeuronMocap.Telemetry;

namespace NeuronMocap;

/// <content>Options that only the .NET build has.</content>
public sealed partial class NeuronReaderOptions
{
    /// <summary>
    /// Creates the log of the reader; null, the default, for no log. The category is "NeuronMocap.NeuronReader"; <see cref="ReaderEventId"/> lists the
    /// event ids.
    /// </summary>
    /// <remarks>
    /// Every change of the connection's state is one line. Lost and dropped frames, skipped bytes and failed handlers are at most one line every 10 s.
    /// </remarks>
    public ILoggerFactory? LoggerFactory { get; set; }

    internal Action<ReaderEvent>? CreateLog() => LoggerFactory is { } factory ? new ReaderLogger(factory).Write : null;
}
