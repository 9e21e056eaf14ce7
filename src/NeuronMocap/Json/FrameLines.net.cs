using System.Buffers;
using System.Diagnostics.CodeAnalysis;
using System.Numerics;
using System.Text.Json;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Json;

/// <summary>Writes frames as lines of JSON, which docs/reference/json.md describes.</summary>
/// <remarks>
/// All lines share one buffer: the result of a method is valid until the next call. A line for a frame allocates nothing once the buffer is large
/// enough. Not thread-safe.
/// </remarks>
[SuppressMessage("Design", "CA1001", Justification = "The writer holds nothing but the buffer.")]
internal class FrameLines
{
    private static readonly JsonEncodedText[] Orders = [.. Enum.GetNames<RotationOrder>().Select(static name => JsonEncodedText.Encode(name))];

    private readonly ArrayBufferWriter<byte> _buffer = new(16 * 1024);
    private readonly JsonClock _clock;
    private readonly BoneTransform[] _world = new BoneTransform[BoneHierarchy.BoneCount];

    public FrameLines(JsonClock clock) => (_clock, Json) = (clock, new Utf8JsonWriter(_buffer));

    protected Utf8JsonWriter Json { get; }

    /// <summary>Describes the frames of an avatar from here on.</summary>
    public ReadOnlySpan<byte> Skeleton(MotionFrame frame)
    {
        Begin("skeleton"u8);
        WriteAvatar(frame);
        WriteOrigin(frame);
        Json.WriteString("rotationOrder"u8, Orders[(int)frame.Format.RotationOrder]);
        Json.WriteString("variant"u8, frame.Format.Variant.ToString());
        Json.WriteNumber("valueCount"u8, frame.Values.Length);
        Json.WriteStartArray("bones"u8);
        foreach (Bone bone in frame.HasSkeleton ? BoneHierarchy.Bones : [])
            Json.WriteStringValue(BoneHierarchy.GetName(bone, frame.Format.Variant));

        Json.WriteEndArray();
        Json.WriteStartArray("parents"u8);
        foreach (Bone bone in frame.HasSkeleton ? BoneHierarchy.Bones : [])
            Json.WriteNumberValue((int?)BoneHierarchy.GetParent(bone, frame.Format.Variant) ?? -1);

        Json.WriteEndArray();
        return End();
    }

    public ReadOnlySpan<byte> Frame(MotionFrame frame)
    {
        Begin("frame"u8);
        WriteAvatar(frame);
        Json.WriteBoolean("displacement"u8, frame.Header.HasDisplacement);
        Json.WriteBoolean("reference"u8, frame.Header.HasReference);
        WriteOrigin(frame);
        Json.WriteString("rotationOrder"u8, Orders[(int)frame.Format.RotationOrder]);
        Json.WriteTimecode(frame.Timecode);
        WritePositions(frame);
        Json.WriteValues(frame.Values);
        return End();
    }

    public ReadOnlySpan<byte> Calculation(CalculationFrame frame)
    {
        Begin("calculation"u8);
        WriteAvatar(frame);
        WriteOrigin(frame);
        Json.WriteValues(frame.Values);
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
        Json.WriteNumber("category"u8, frame.Header.Category);
        Json.WriteNumber("dataMask"u8, frame.Header.DataMask);
        Json.WriteNumber("bones"u8, frame.HasSkeleton ? BoneHierarchy.BoneCount : 0);
        if (frame.HasSkeleton)
            WriteBones(frame);
        else
            Json.WriteValues(frame.Values);

        return End();
    }

    protected void Begin(ReadOnlySpan<byte> type)
    {
        _buffer.ResetWrittenCount();
        Json.Reset();
        Json.WriteStartObject();
        Json.WriteString("type"u8, type);
    }

    private void WriteAvatar(AvatarFrame frame)
    {
        Json.WriteNumber("avatar"u8, (uint)frame.AvatarIndex);
        Json.WriteString("name"u8, frame.AvatarName);
        if (frame.FrameIndex is { } counter)
            Json.WriteNumber("index"u8, counter);
        else
            Json.WriteNull("index"u8);
    }

    protected void WriteTime(long timestamp)
    {
        Json.WriteNumber("time"u8, _clock.SecondsTo(timestamp));
        Json.WriteString("utc"u8, _clock.UtcOf(timestamp));
    }

    // Appended after the older members, because scripts rely on the start of a line.
    private void WriteOrigin(AvatarFrame frame)
    {
        Json.WriteNumber("sender"u8, frame.Sender);
        WriteTime(frame.Timestamp);
    }

    private void WritePositions(MotionFrame frame)
    {
        if (!frame.HasSkeleton)
        {
            Json.WriteNull("positions"u8);
            return;
        }

        frame.CopyWorldTransforms(_world);
        Json.WriteStartArray("positions"u8);
        foreach (BoneTransform bone in _world)
        {
            Vector3 position = bone.Position;
            Json.WriteValue(position.X);
            Json.WriteValue(position.Y);
            Json.WriteValue(position.Z);
        }

        Json.WriteEndArray();
    }

    // The last of a bone's 21 values is the flag.
    private void WriteBones(StudioCalculationFrame frame)
    {
        int perBone = frame.Values.Length / BoneHierarchy.BoneCount;
        Json.WriteStartArray("values"u8);
        for (int i = 0; i < frame.Values.Length; i++)
        {
            if (i % perBone < perBone - 1)
                Json.WriteValue(frame.Values[i]);
        }

        Json.WriteEndArray();
        Json.WriteStartArray("sensorsLost"u8);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            if (frame.IsSensorLost(bone))
                Json.WriteNumberValue((int)bone);
        }

        Json.WriteEndArray();
    }

    protected ReadOnlySpan<byte> End()
    {
        Json.WriteEndObject();
        Json.Flush();
        _buffer.GetSpan(1)[0] = (byte)'\n';
        _buffer.Advance(1);
        return _buffer.WrittenSpan;
    }
}
