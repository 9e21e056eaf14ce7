using System.Diagnostics;

namespace NeuronMocap.Telemetry;

// Determines the log level for a change of the connection's state. A server that is down for an hour causes one warning, not one for every attempt: a
// problem is reported again only if frames arrived in between. A server that repeatedly sends a frame and closes causes one warning in ten seconds. The
// last line above Debug always shows the current situation. An outage gets a line at the first attempt after the ten seconds at the latest, and Receiving
// follows any reported problem. One thread at a time.
internal sealed class StatusLevels
{
    private static readonly long Period = 10 * Stopwatch.Frequency;

    private readonly Dictionary<(ConnectionState State, ConnectionReason Reason), (long Time, int Reception)> _lastByStatus = [];
    private int _receptions;
    private ConnectionState _lastLine = ConnectionState.Created;
    private StreamFormat _lastFormat;

    public ReaderEventLevel LevelOf(in ConnectionStatus status)
    {
        if (status.State == ConnectionState.Receiving)
            _receptions++;

        ReaderEventLevel level = status.State switch
        {
            ConnectionState.Receiving when status.Reason != ConnectionReason.None && IsNew(status) => ReaderEventLevel.Warning,
            ConnectionState.Receiving when _lastLine != ConnectionState.Receiving || _lastFormat != status.Format => ReaderEventLevel.Information,
            ConnectionState.Connected when IsNew(status) => ReaderEventLevel.Information,
            ConnectionState.Silent or ConnectionState.Waiting when IsNew(status) => ReaderEventLevel.Warning,
            ConnectionState.Stopped when status.Reason is ConnectionReason.Requested or ConnectionReason.ClosedByPeer or ConnectionReason.EndOfRecording => ReaderEventLevel.Information,
            ConnectionState.Stopped => ReaderEventLevel.Error,
            _ => ReaderEventLevel.Debug,
        };
        if (level != ReaderEventLevel.Debug)
        {
            _lastLine = status.State;
            _lastFormat = status.Format;
        }

        return level;
    }

    private bool IsNew(in ConnectionStatus status)
    {
        // Silence is not reported again while it lasts, and cannot occur more often than its timeout allows, so it needs no period.
        if (_lastByStatus.TryGetValue((status.State, status.Reason), out (long Time, int Reception) last)
            && (last.Reception == _receptions || (status.State != ConnectionState.Silent && status.Timestamp - last.Time < Period)))
        {
            return false;
        }

        _lastByStatus[(status.State, status.Reason)] = (status.Timestamp, _receptions);
        return true;
    }
}
