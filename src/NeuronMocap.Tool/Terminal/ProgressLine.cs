using System.Diagnostics;

namespace NeuronMocap.Tool.Terminal;

/// <summary>
/// How far long work has come, in one line on standard error that comes after a second, and goes when the work is done. Nothing where no person
/// looks. One thread at a time.
/// </summary>
internal sealed class ProgressLine(StandardStreams streams, string work) : IProgress<double>, IDisposable
{
    private const string Erase = "\r\e[K";

    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan Interval = TimeSpan.FromMilliseconds(100);

    private readonly string _work = TerminalText.Clean(work);
    private readonly long _start = Stopwatch.GetTimestamp();
    private TimeSpan _next = Patience;
    private bool _isShown;

    /// <summary>Tells how far the work is; may be called for every frame.</summary>
    /// <param name="value">The part that is done, 0 to 1.</param>
    public void Report(double value)
    {
        TimeSpan elapsed = Stopwatch.GetElapsedTime(_start);
        if (!streams.IsErrorTerminal || elapsed < _next)
            return;

        _next = elapsed + Interval;
        _isShown = true;
        TimeSpan rest = value > 0 ? elapsed * ((1 - value) / value) : TimeSpan.Zero;
        streams.Error.Write(Quantity.Format($"{Erase}{_work} {value * 100:0} %, {Quantity.Duration(rest)} left"));
        streams.Error.Flush();
    }

    public void Dispose()
    {
        if (_isShown)
            streams.Error.Write(Erase);
    }
}
