using System.Diagnostics;
using NeuronMocap.Diagnostics;
using NeuronMocap.Json;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Output;

/// <summary>Writes the lines of --json, which docs/reference/json.md describes.</summary>
/// <remarks>As the base class: one buffer for all lines, and not thread-safe.</remarks>
internal sealed partial class JsonLines : FrameLines
{
    private readonly JsonClock _clock;

    public JsonLines()
        : this(new JsonClock())
    {
    }

    public JsonLines(JsonClock clock)
        : base(clock) => _clock = clock;

    /// <summary>Writes the first line: the program and its source.</summary>
    public ReadOnlySpan<byte> Start(string source)
    {
        Begin("start"u8);
        Json.WriteString("program"u8, "neuron-mocap"u8);
        Json.WriteString("version"u8, typeof(JsonLines).Assembly.GetName().Version?.ToString(3));
        Json.WriteString("source"u8, source);
        WriteTime(_clock.Start);
        return End();
    }

    public ReadOnlySpan<byte> Status(ConnectionStatus status)
    {
        Begin("status"u8);
        Json.WriteString("state"u8, status.State.ToString());
        Json.WriteString("message"u8, OptionNames.Translate(status.Message));
        Json.WriteString("format"u8, status.Format.ToString());
        Json.WriteString("reason"u8, ReasonCode.Of(status.Reason));
        Json.WriteNumber("attempt"u8, status.Attempt);
        Json.WriteNumber("retryIn"u8, status.RetryIn?.TotalSeconds);
        Json.WriteEndPoint("local"u8, status.LocalEndPoint);
        Json.WriteEndPoint("remote"u8, status.RemoteEndPoint);
        Json.WriteNumber("receiveBuffer"u8, status.ReceiveBufferSize);
        WriteTime(status.Timestamp);
        Json.WriteNumber("receiveBufferRequested"u8, status.RequestedReceiveBufferSize);
        return End();
    }

    public ReadOnlySpan<byte> FileFailed(FileFailure failure)
    {
        Begin("fileFailed"u8);
        Json.WriteString("kind"u8, failure.Kind);
        Json.WriteString("file"u8, failure.File);
        Json.WriteString("message"u8, failure.Reason);
        Json.WriteNumber("lostFrames"u8, failure.IsExport ? failure.Lost : null);
        Json.WriteNumber("lostPieces"u8, failure.IsExport ? null : failure.Lost);
        WriteTime(failure.Timestamp);
        return End();
    }

    public ReadOnlySpan<byte> Summary(ReaderStatistics statistics)
    {
        BeginSummary(statistics);
        return End();
    }

    public ReadOnlySpan<byte> Step(DiagnosisStep step)
    {
        Begin("step"u8);
        Json.WriteString("name"u8, step.Name);
        Json.WriteString("outcome"u8, step.Outcome.ToString());
        Json.WriteString("detail"u8, OptionNames.Translate(step.Detail));
        Json.WriteNumber("seconds"u8, step.Elapsed.TotalSeconds);
        WriteTime(Stopwatch.GetTimestamp());
        return End();
    }

    public ReadOnlySpan<byte> Diagnosis(StreamDiagnosis diagnosis)
    {
        Begin("diagnosis"u8);
        Json.WriteString("verdict"u8, diagnosis.Verdict.ToString());
        Json.WriteBoolean("framesArrive"u8, diagnosis.IsReceiving);
        Json.WriteStartArray("findings"u8);
        foreach (DiagnosisVerdict verdict in diagnosis.Verdicts)
            Json.WriteStringValue(verdict.ToString());

        Json.WriteEndArray();
        Json.WriteString("summary"u8, OptionNames.Translate(diagnosis.Summary));
        Json.WriteString("advice"u8, diagnosis.Advice is { } advice ? OptionNames.Translate(advice) : null);
        Json.WriteString("code"u8, diagnosis.SampleCode);
        Json.WriteStartArray("avatars"u8);
        foreach (DiagnosedAvatar avatar in diagnosis.Avatars)
            WriteAvatar(avatar);

        Json.WriteEndArray();
        Json.WriteNumber("seconds"u8, diagnosis.Elapsed.TotalSeconds);
        WriteTime(Stopwatch.GetTimestamp());
        return End();
    }

    private void BeginSummary(ReaderStatistics statistics)
    {
        Begin("summary"u8);
        Json.WriteNumber("frames"u8, statistics.MotionFrames);
        Json.WriteNumber("calculationFrames"u8, statistics.CalculationFrames);
        Json.WriteNumber("lost"u8, statistics.Lost);
        Json.WriteNumber("dropped"u8, statistics.Dropped);
        Json.WriteNumber("skippedBytes"u8, statistics.BytesSkipped);
        Json.WriteNumber("seconds"u8, statistics.Duration.TotalSeconds);
        Json.WriteNumber("gaps"u8, statistics.Gaps);
        Json.WriteNumber("restarts"u8, statistics.Restarts);
        Json.WriteNumber("reconnects"u8, statistics.Reconnects);
        Json.WriteNumber("studioCalculationFrames"u8, statistics.StudioCalculationFrames);
        Json.WriteNumber("refusedDatagrams"u8, statistics.RefusedDatagrams);
        Json.WriteNumber("calculationReconnects"u8, statistics.CalculationReconnects);
        WriteTime(Stopwatch.GetTimestamp());
        Json.WriteNumber("rejectedMessages"u8, statistics.RejectedMessages);
    }

    private void WriteAvatar(DiagnosedAvatar avatar)
    {
        Json.WriteStartObject();
        Json.WriteNumber("avatar"u8, (uint)avatar.Index);
        Json.WriteString("name"u8, avatar.Name);
        Json.WriteString("kind"u8, avatar.Kind.ToString());
        Json.WriteString("version"u8, avatar.Version.ToString());
        Json.WriteNumber("values"u8, avatar.ValueCount);
        Json.WriteBoolean("displacement"u8, avatar.HasDisplacement);
        Json.WriteBoolean("reference"u8, avatar.HasReference);
        Json.WriteNumber("frames"u8, avatar.Frames);
        Json.WriteNumber("lost"u8, avatar.Lost);
        Json.WriteNumber("rate"u8, avatar.FrameRate);
        Json.WriteEndObject();
    }
}
