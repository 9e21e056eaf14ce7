using System.Diagnostics;
using System.Runtime.CompilerServices;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap;

/// <summary>One avatar at one moment, as received: the members that motion and calculation frames have in common.</summary>
/// <remarks>
/// <para>
/// Handlers, <see cref="LatestFrames"/> and <see cref="Recording.RecordedFrameReader"/> reuse their frame objects. Such a frame is valid until the handler
/// returns, or until you take the next frame. Use <c>Clone</c> to make a copy that stays valid.
/// </para>
/// <para>
/// Every member of a frame that is no longer valid throws an <see cref="InvalidOperationException"/>. Reusing the objects avoids allocations. A handler
/// gets the same object again 31 frames later. <see cref="LatestFrames"/> returns it again 7 frames of the avatar later. An object that was read too late
/// is not reused.
/// </para>
/// <para>
/// The spans of a frame are not checked: do not use them after the frame expires. If one thread reads a frame while another thread lets it expire, the
/// reading thread gets an exception or parts of the next frame.
/// </para>
/// </remarks>
public abstract class AvatarFrame
{
    private protected FrameData _data;
    private long _timestamp;

    private protected AvatarFrame()
    {
    }

    /// <summary>
    /// Number of the avatar on the server, from 0. The number is unsigned in the stream. Numbers from 2³¹ on, which no server uses, are negative here.
    /// </summary>
    public abstract int AvatarIndex { get; }

    /// <summary>Name of the avatar on the server. Allocates only when a name is new.</summary>
    public abstract string AvatarName { get; }

    /// <summary>
    /// The server's frame counter; null if the header has none. Use it to find gaps, and use <see cref="Timestamp"/> for time. Its first value, where it
    /// wraps, and the effect of frequency reduction are not documented.
    /// </summary>
    public abstract uint? FrameIndex { get; }

    /// <summary>All values after the header, in stream order, bit for bit as received. Valid as long as the frame.</summary>
    public ReadOnlySpan<float> Values => _data.Values;

    /// <summary>The whole packet, header and values, bit for bit as received. Valid as long as the frame.</summary>
    /// <remarks>
    /// Sent over TCP or UDP, the packet is the same frame for every client. A line of text has no packet. The span is then a packet with
    /// the values of the line, whose header ends with 0 instead of the second token (protocol.md section 3).
    /// </remarks>
    public ReadOnlySpan<byte> Packet => _data.Packet;

    /// <summary>
    /// When the bytes that completed the frame were received, in ticks of <see cref="Stopwatch"/>. This clock never jumps.
    /// </summary>
    public long Timestamp => _data.WhileValid(_timestamp);

    /// <summary>Time since the frame was received.</summary>
    public TimeSpan Age => PreciseTime.FromSeconds((Stopwatch.GetTimestamp() - Timestamp) / (double)Stopwatch.Frequency);

    /// <summary>
    /// Number of the sender that the frame came from. Over UDP, 0 is the first server that sent, and 1 is the next; over TCP it is always 0.
    /// </summary>
    /// <remarks>
    /// Two servers can use the same <see cref="AvatarIndex"/>. A server keeps its number when it restarts on another port of the same address.
    /// </remarks>
    public int Sender => _data.WhileValid(PacketOrigin.SenderOf(Origin));

    /// <summary>Creates a copy that owns its memory and stays valid.</summary>
    /// <returns>A frame of the same kind, equal to this one, including its time of receipt.</returns>
    public AvatarFrame Clone() => CreateClone();

    // The sender and its current run. Another run of the sender can start its frame numbers anywhere.
    internal int Origin { get; private protected set; }

    internal bool WasReadLate => _data.WasReadLate;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void Borrow(in ReceivedPacket packet)
    {
        _data.Borrow(packet.Array, packet.Offset, packet.Length);
        _timestamp = packet.Timestamp;
        Origin = packet.Origin;
        OnData();
    }

    // Called when the consumer is finished with the frame.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void Expire() => _data.Expire();

    private protected abstract AvatarFrame CreateClone();

    // Header fields are read on demand, because most handlers need only a few of them.
    private protected virtual void OnData()
    {
    }

    private protected void CopyFrom(AvatarFrame other)
    {
        _data.Copy(other._data.Packet);
        _timestamp = other._timestamp;
        Origin = other.Origin;
        OnData();
    }
}
