using System.Buffers.Binary;
using System.Diagnostics;
using NeuronMocap.AspNetCore;
using NeuronMocap.Tool.View.Performers;

namespace NeuronMocap.Tool.View.Live;

/// <summary>Writes frames as messages for /motion, each with the number of its performer. Used by one thread.</summary>
internal sealed class PoseMessages(PerformerNumbers numbers)
{
    // The avatar number in a compact pose (docs/reference/compact-pose.md).
    private const int AvatarOffset = 4;

    private readonly MessageEncoder _encoder = new();
    private long _encoded;

    /// <summary>Number of messages that were written. It does not grow while no page shows motion.</summary>
    public long Encoded => Interlocked.Read(ref _encoded);

    /// <summary>Time from the receipt of each performer's frames to their messages.</summary>
    public LatencyMeter Latency { get; } = new();

    /// <summary>Makes a message, which the caller releases. Null if the form has none for this frame.</summary>
    public MotionMessage? Encode(AvatarFrame frame, WebSocketForm form)
    {
        var key = PerformerKey.Of(frame);
        if (numbers.Find(key) is not { } number || _encoder.Encode(frame, form) is not { } message)
            return null;

        if (form == WebSocketForm.Pose)
            BinaryPrimitives.WriteInt32LittleEndian(message.Reserve(message.Bytes.Length)[AvatarOffset..], number);

        Interlocked.Increment(ref _encoded);
        Latency.Add(key, Stopwatch.GetElapsedTime(frame.Timestamp));
        return message;
    }
}
