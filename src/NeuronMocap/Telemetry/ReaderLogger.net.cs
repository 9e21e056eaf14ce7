using Microsoft.Extensions.Logging;

namespace NeuronMocap.Telemetry;

// Writes a reader's events to a logger, with their figures as fields.
internal sealed partial class ReaderLogger(ILoggerFactory factory)
{
    private readonly ILogger _logger = factory.CreateLogger("NeuronMocap.NeuronReader");

    public void Write(ReaderEvent reported)
    {
        LogLevel level = ToLogLevel(reported.Level);
        if (!_logger.IsEnabled(level))
            return;

        switch (reported.Id)
        {
            case ReaderEventId.FramesLost:
                FramesLost(reported.Reader, reported.Message, reported.Count, reported.Total);
                break;
            case ReaderEventId.FramesDropped:
                FramesDropped(reported.Reader, reported.Message, reported.Subject, reported.Count, reported.Total);
                break;
            case ReaderEventId.BytesSkipped:
                BytesSkipped(reported.Reader, reported.Message, reported.Subject, reported.Count, reported.Total);
                break;
            case ReaderEventId.CallbackFailed:
                CallbackFailed(reported.Exception, reported.Reader, reported.Message, reported.Count, reported.Total);
                break;
            case ReaderEventId.RecordingStarted:
                RecordingStarted(reported.Reader, reported.Message, reported.Subject);
                break;
            case ReaderEventId.RecordingStopped:
                RecordingStopped(reported.Reader, reported.Message, reported.Subject);
                break;
            case ReaderEventId.RecordingIncomplete:
                RecordingIncomplete(reported.Reader, reported.Message, reported.Subject, reported.Count, reported.Total);
                break;
            case ReaderEventId.RecordingFailed:
                RecordingFailed(reported.Exception, reported.Reader, reported.Message, reported.Subject);
                break;
            case ReaderEventId.RecordingFileKept:
                RecordingFileKept(reported.Reader, reported.Message, reported.Subject);
                break;
            case ReaderEventId.ExportStarted:
                ExportStarted(reported.Reader, reported.Message, reported.Subject);
                break;
            case ReaderEventId.ExportStopped:
                ExportStopped(reported.Reader, reported.Message, reported.Subject);
                break;
            case ReaderEventId.ExportIncomplete:
                ExportIncomplete(reported.Reader, reported.Message, reported.Subject, reported.Count, reported.Total);
                break;
            case ReaderEventId.ExportFailed:
                ExportFailed(reported.Exception, reported.Reader, reported.Message, reported.Subject);
                break;
            default:
                WriteState(level, reported);
                break;
        }
    }

    private void WriteState(LogLevel level, in ReaderEvent reported)
    {
        ConnectionStatus status = reported.Status.GetValueOrDefault();
        string state = status.State.ToString();
        string reason = status.Reason.ToString();
        switch (reported.Id)
        {
            case ReaderEventId.Connecting:
                Connecting(level, reported.Reader, state, reported.Message, status.Attempt);
                break;
            case ReaderEventId.Connected:
                Connected(level, reported.Reader, state, reported.Message, status.LocalEndPoint, status.RemoteEndPoint);
                break;
            case ReaderEventId.Receiving:
                Receiving(level, reported.Reader, state, reported.Message);
                break;
            case ReaderEventId.Silent:
                Silent(level, reported.Reader, state, reported.Message, reason);
                break;
            case ReaderEventId.Waiting:
                Waiting(level, reported.Reader, state, reported.Message, reason, status.Attempt, status.RetryIn.GetValueOrDefault().TotalSeconds);
                break;
            default:
                Stopped(level, reported.Reader, state, reported.Message, reason);
                break;
        }
    }

    private static LogLevel ToLogLevel(ReaderEventLevel level) => level switch
    {
        ReaderEventLevel.Debug => LogLevel.Debug,
        ReaderEventLevel.Information => LogLevel.Information,
        ReaderEventLevel.Warning => LogLevel.Warning,
        _ => LogLevel.Error,
    };

    [LoggerMessage(EventId = 1, Message = "{Reader}: {State}: {Message} (attempt {Attempt})")]
    private partial void Connecting(LogLevel level, string reader, string state, string message, int attempt);

    [LoggerMessage(EventId = 2, Message = "{Reader}: {State}: {Message} ({LocalEndPoint}, {RemoteEndPoint})")]
    private partial void Connected(
        LogLevel level, string reader, string state, string message, System.Net.EndPoint? localEndPoint, System.Net.EndPoint? remoteEndPoint);

    [LoggerMessage(EventId = 3, Message = "{Reader}: {State}: {Message}")]
    private partial void Receiving(LogLevel level, string reader, string state, string message);

    [LoggerMessage(EventId = 4, Message = "{Reader}: {State} ({Reason}): {Message}")]
    private partial void Silent(LogLevel level, string reader, string state, string message, string reason);

    [LoggerMessage(EventId = 5, Message = "{Reader}: {State} ({Reason}): {Message} (attempt {Attempt}, next in {RetrySeconds} s)")]
    private partial void Waiting(LogLevel level, string reader, string state, string message, string reason, int attempt, double retrySeconds);

    [LoggerMessage(EventId = 6, Message = "{Reader}: {State} ({Reason}): {Message}")]
    private partial void Stopped(LogLevel level, string reader, string state, string message, string reason);

    [LoggerMessage(EventId = 10, Level = LogLevel.Warning, Message = "{Reader}: {Message} ({Count} of {Total})")]
    private partial void FramesLost(string reader, string message, long count, long total);

    [LoggerMessage(EventId = 11, Level = LogLevel.Warning, Message = "{Reader}: {Message} ({Consumer}: {Count} of {Total})")]
    private partial void FramesDropped(string reader, string message, string? consumer, long count, long total);

    [LoggerMessage(EventId = 12, Level = LogLevel.Warning, Message = "{Reader}: {Message} ({SkipReason}: {Count} of {Total})")]
    private partial void BytesSkipped(string reader, string message, string? skipReason, long count, long total);

    [LoggerMessage(EventId = 13, Level = LogLevel.Error, Message = "{Reader}: {Message} ({Count} of {Total})")]
    private partial void CallbackFailed(Exception? exception, string reader, string message, long count, long total);

    [LoggerMessage(EventId = 20, Level = LogLevel.Information, Message = "{Reader}: {Message} ({Path})")]
    private partial void RecordingStarted(string reader, string message, string? path);

    [LoggerMessage(EventId = 21, Level = LogLevel.Information, Message = "{Reader}: {Message} ({Path})")]
    private partial void RecordingStopped(string reader, string message, string? path);

    [LoggerMessage(EventId = 22, Level = LogLevel.Warning, Message = "{Reader}: {Message} ({Path}: {Count} of {Total})")]
    private partial void RecordingIncomplete(string reader, string message, string? path, long count, long total);

    [LoggerMessage(EventId = 23, Level = LogLevel.Error, Message = "{Reader}: {Message} ({Path})")]
    private partial void RecordingFailed(Exception? exception, string reader, string message, string? path);

    [LoggerMessage(EventId = 24, Level = LogLevel.Warning, Message = "{Reader}: {Message} ({Path})")]
    private partial void RecordingFileKept(string reader, string message, string? path);

    [LoggerMessage(EventId = 30, Level = LogLevel.Information, Message = "{Reader}: {Message} ({Path})")]
    private partial void ExportStarted(string reader, string message, string? path);

    [LoggerMessage(EventId = 31, Level = LogLevel.Information, Message = "{Reader}: {Message} ({Path})")]
    private partial void ExportStopped(string reader, string message, string? path);

    [LoggerMessage(EventId = 32, Level = LogLevel.Warning, Message = "{Reader}: {Message} ({Path}: {Count} of {Total})")]
    private partial void ExportIncomplete(string reader, string message, string? path, long count, long total);

    [LoggerMessage(EventId = 33, Level = LogLevel.Error, Message = "{Reader}: {Message} ({Path})")]
    private partial void ExportFailed(Exception? exception, string reader, string message, string? path);
}
