using System.Buffers;
using System.Diagnostics;
using System.Diagnostics.CodeAnalysis;
using System.Numerics;
using System.Text.Json;
using NeuronMocap.Diagnostics;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Output;

/// <summary>Writes the lines of --json, which docs/reference/json.md describes.</summary>
/// <remarks>
/// All lines share one buffer: the result of a method is valid until the next call. A line for a frame allocates nothing once the buffer is large
/// enough. Not thread-safe.
/// </remarks>
[SuppressMessage("Design", "CA1001", Justification = "The writer holds nothing but the buffer.")]
internal sealed partial class JsonLines
{
    private static readonly JsonEncodedText[] Orders = [.. Enum.GetNames<RotationOrder>().Select(static name => JsonEncodedText.Encode(name))];

    private readonly ArrayBufferWriter<byte> _buffer = new(16 * 1024);
    private readonly Utf8JsonWriter _json;
    private readonly JsonClock _clock;
    private readonly BoneTransform[] _world = new BoneTransform[BoneHierarchy.BoneCount];

    public JsonLines()
        : this(new JsonClock())
    {
    }

    public JsonLines(JsonClock clock) => (_clock, _json) = (clock, new Utf8JsonWriter(_buffer));

    /// <summary>Writes the first line: the program and its source.</summary>
    public ReadOnlySpan<byte> Start(string source)
    {
        Begin("start"u8);
        _json.WriteString("program"u8, "neuron-mocap"u8);
        _json.WriteString("version"u8, typeof(JsonLines).Assembly.GetName().Version?.ToString(3));
        _json.WriteString("source"u8, source);
        WriteTime(_clock.Start);
        return End();
    }

    /// <summary>Describes the frames of an avatar from here on.</summary>
    public ReadOnlySpan<byte> Skeleton(MotionFrame frame)
    {
        Begin("skeleton"u8);
        WriteAvatar(frame);
        WriteOrigin(frame);
        _json.WriteString("rotationOrder"u8, Orders[(int)frame.Format.RotationOrder]);
        _json.WriteString("variant"u8, frame.Format.Variant.ToString());
        _json.WriteNumber("valueCount"u8, frame.Values.Length);
        _json.WriteStartArray("bones"u8);
        foreach (Bone bone in frame.HasSkeleton ? BoneHierarchy.Bones : [])
            _json.WriteStringValue(BoneHierarchy.GetName(bone, frame.Format.Variant));

        _json.WriteEndArray();
        _json.WriteStartArray("parents"u8);
        foreach (Bone bone in frame.HasSkeleton ? BoneHierarchy.Bones : [])
            _json.WriteNumberValue((int?)BoneHierarchy.GetParent(bone, frame.Format.Variant) ?? -1);

        _json.WriteEndArray();
        return End();
    }

    public ReadOnlySpan<byte> Frame(MotionFrame frame)
    {
        Begin("frame"u8);
        WriteAvatar(frame);
        _json.WriteBoolean("displacement"u8, frame.Header.HasDisplacement);
        _json.WriteBoolean("reference"u8, frame.Header.HasReference);
        WriteOrigin(frame);
        _json.WriteString("rotationOrder"u8, Orders[(int)frame.Format.RotationOrder]);
        _json.WriteTimecode(frame.Timecode);
        WritePositions(frame);
        _json.WriteValues(frame.Values);
        return End();
    }

    public ReadOnlySpan<byte> Calculation(CalculationFrame frame)
    {
        Begin("calculation"u8);
        WriteAvatar(frame);
        WriteOrigin(frame);
        _json.WriteValues(frame.Values);
        return End();
    }

    /// <summary>
    /// Writes a frame of Axis Studio: 20 numbers for each of the 59 bones, and the bones that have lost their sensor. Other layouts are written as
    /// plain numbers.
    /// </summary>
    public ReadOnlySpan<byte> StudioCalculation(StudioCalculationFrame frame)
    {
        Begin("studioCalculation"u8);
        WriteAvatar(frame);
        WriteOrigin(frame);
        _json.WriteNumber("category"u8, frame.Header.Category);
        _json.WriteNumber("dataMask"u8, frame.Header.DataMask);
        _json.WriteNumber("bones"u8, frame.HasSkeleton ? BoneHierarchy.BoneCount : 0);
        if (frame.HasSkeleton)
            WriteBones(frame);
        else
            _json.WriteValues(frame.Values);

        return End();
    }

    public ReadOnlySpan<byte> Status(ConnectionStatus status)
    {
        Begin("status"u8);
        _json.WriteString("state"u8, status.State.ToString());
        _json.WriteString("message"u8, OptionNames.Translate(status.Message));
        _json.WriteString("format"u8, status.Format.ToString());
        _json.WriteString("reason"u8, ReasonCode.Of(status.Reason));
        _json.WriteNumber("attempt"u8, status.Attempt);
        _json.WriteNumber("retryIn"u8, status.RetryIn?.TotalSeconds);
        _json.WriteEndPoint("local"u8, status.LocalEndPoint);
        _json.WriteEndPoint("remote"u8, status.RemoteEndPoint);
        _json.WriteNumber("receiveBuffer"u8, status.ReceiveBufferSize);
        WriteTime(status.Timestamp);
        _json.WriteNumber("receiveBufferRequested"u8, status.RequestedReceiveBufferSize);
        return End();
    }

    public ReadOnlySpan<byte> FileFailed(FileFailure failure)
    {
        Begin("fileFailed"u8);
        _json.WriteString("kind"u8, failure.Kind);
        _json.WriteString("file"u8, failure.File);
        _json.WriteString("message"u8, failure.Reason);
        _json.WriteNumber("lostFrames"u8, failure.IsExport ? failure.Lost : null);
        _json.WriteNumber("lostPieces"u8, failure.IsExport ? null : failure.Lost);
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
        _json.WriteString("name"u8, step.Name);
        _json.WriteString("outcome"u8, step.Outcome.ToString());
        _json.WriteString("detail"u8, OptionNames.Translate(step.Detail));
        _json.WriteNumber("seconds"u8, step.Elapsed.TotalSeconds);
        WriteTime(Stopwatch.GetTimestamp());
        return End();
    }

    public ReadOnlySpan<byte> Diagnosis(StreamDiagnosis diagnosis)
    {
        Begin("diagnosis"u8);
        _json.WriteString("verdict"u8, diagnosis.Verdict.ToString());
        _json.WriteBoolean("framesArrive"u8, diagnosis.IsReceiving);
        _json.WriteStartArray("findings"u8);
        foreach (DiagnosisVerdict verdict in diagnosis.Verdicts)
            _json.WriteStringValue(verdict.ToString());

        _json.WriteEndArray();
        _json.WriteString("summary"u8, OptionNames.Translate(diagnosis.Summary));
        _json.WriteString("advice"u8, diagnosis.Advice is { } advice ? OptionNames.Translate(advice) : null);
        _json.WriteString("code"u8, diagnosis.SampleCode);
        _json.WriteStartArray("avatars"u8);
        foreach (DiagnosedAvatar avatar in diagnosis.Avatars)
            WriteAvatar(avatar);

        _json.WriteEndArray();
        _json.WriteNumber("seconds"u8, diagnosis.Elapsed.TotalSeconds);
        WriteTime(Stopwatch.GetTimestamp());
        return End();
    }

    private void Begin(ReadOnlySpan<byte> type)
    {
        _buffer.ResetWrittenCount();
        _json.Reset();
        _json.WriteStartObject();
        _json.WriteString("type"u8, type);
    }

    private void BeginSummary(ReaderStatistics statistics)
    {
        Begin("summary"u8);
        _json.WriteNumber("frames"u8, statistics.MotionFrames);
        _json.WriteNumber("calculationFrames"u8, statistics.CalculationFrames);
        _json.WriteNumber("lost"u8, statistics.Lost);
        _json.WriteNumber("dropped"u8, statistics.Dropped);
        _json.WriteNumber("skippedBytes"u8, statistics.BytesSkipped);
        _json.WriteNumber("seconds"u8, statistics.Duration.TotalSeconds);
        _json.WriteNumber("gaps"u8, statistics.Gaps);
        _json.WriteNumber("restarts"u8, statistics.Restarts);
        _json.WriteNumber("reconnects"u8, statistics.Reconnects);
        _json.WriteNumber("studioCalculationFrames"u8, statistics.StudioCalculationFrames);
        _json.WriteNumber("refusedDatagrams"u8, statistics.RefusedDatagrams);
        _json.WriteNumber("calculationReconnects"u8, statistics.CalculationReconnects);
        WriteTime(Stopwatch.GetTimestamp());
    }

    private void WriteAvatar(AvatarFrame frame)
    {
        _json.WriteNumber("avatar"u8, (uint)frame.AvatarIndex);
        _json.WriteString("name"u8, frame.AvatarName);
        if (frame.FrameIndex is { } counter)
            _json.WriteNumber("index"u8, counter);
        else
            _json.WriteNull("index"u8);
    }

    // Appended after the older members, because scripts rely on the start of a line.
    private void WriteOrigin(AvatarFrame frame)
    {
        _json.WriteNumber("sender"u8, frame.Sender);
        WriteTime(frame.Timestamp);
    }

    private void WriteAvatar(DiagnosedAvatar avatar)
    {
        _json.WriteStartObject();
        _json.WriteNumber("avatar"u8, (uint)avatar.Index);
        _json.WriteString("name"u8, avatar.Name);
        _json.WriteString("kind"u8, avatar.Kind.ToString());
        _json.WriteString("version"u8, avatar.Version.ToString());
        _json.WriteNumber("values"u8, avatar.ValueCount);
        _json.WriteBoolean("displacement"u8, avatar.HasDisplacement);
        _json.WriteBoolean("reference"u8, avatar.HasReference);
        _json.WriteNumber("frames"u8, avatar.Frames);
        _json.WriteNumber("lost"u8, avatar.Lost);
        _json.WriteNumber("rate"u8, avatar.FrameRate);
        _json.WriteEndObject();
    }

    private void WriteTime(long timestamp)
    {
        _json.WriteNumber("time"u8, _clock.SecondsTo(timestamp));
        _json.WriteString("utc"u8, _clock.UtcOf(timestamp));
    }

    private void WritePositions(MotionFrame frame)
    {
        if (!frame.HasSkeleton)
        {
            _json.WriteNull("positions"u8);
            return;
        }

        frame.CopyWorldTransforms(_world);
        _json.WriteStartArray("positions"u8);
        foreach (BoneTransform bone in _world)
        {
            Vector3 position = bone.Position;
            _json.WriteValue(position.X);
            _json.WriteValue(position.Y);
            _json.WriteValue(position.Z);
        }

        _json.WriteEndArray();
    }

    // The last of a bone's 21 values is the flag.
    private void WriteBones(StudioCalculationFrame frame)
    {
        int perBone = frame.Values.Length / BoneHierarchy.BoneCount;
        _json.WriteStartArray("values"u8);
        for (int i = 0; i < frame.Values.Length; i++)
        {
            if (i % perBone < perBone - 1)
                _json.WriteValue(frame.Values[i]);
        }

        _json.WriteEndArray();
        _json.WriteStartArray("sensorsLost"u8);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            if (frame.IsSensorLost(bone))
                _json.WriteNumberValue((int)bone);
        }

        _json.WriteEndArray();
    }

    private ReadOnlySpan<byte> End()
    {
        _json.WriteEndObject();
        _json.Flush();
        _buffer.GetSpan(1)[0] = (byte)'\n';
        _buffer.Advance(1);
        return _buffer.WrittenSpan;
    }
}
