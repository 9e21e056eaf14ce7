using System.Diagnostics;
using System.Runtime.CompilerServices;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap;

/// <summary>
/// One avatar at one instant, as it came off the wire: what motion and calculation frames have in common.
/// <para>
/// A frame that a handler, a <see cref="LatestFrames"/> or a <see cref="Recording.RecordedFrameReader"/> gets is only lent. It is valid until the
/// handler returns, or until the next frame is taken. <c>Clone</c> makes a copy that stays valid.
/// </para>
/// <para>
/// Every member of a frame that is no longer valid throws an <see cref="InvalidOperationException"/>. The objects are used again in turn, so that
/// nothing is allocated: a handler gets the same object again 31 frames later, and <see cref="LatestFrames"/> gives it 7 frames of
/// the avatar later. An object that was read too late once is not used again. The spans of a frame are not checked: they must not be used for longer than
/// the frame. A thread that reads a frame while another thread lets it expire may get an exception or parts of the next frame.
/// </para>
/// </summary>
public abstract class AvatarFrame
{
    private protected FrameData _data;
    private long _timestamp;

    private protected AvatarFrame()
    {
    }

    /// <summary>Number of the avatar on the server, from 0. The wire has no sign; numbers from 2³¹ on, which no server uses, are negative here.</summary>
    public abstract int AvatarIndex { get; }

    /// <summary>Name of the avatar on the server. Allocates only when a name is new.</summary>
    public abstract string AvatarName { get; }

    /// <summary>
    /// The server's frame counter, or null where the header has none. Its start, its wrap and what frequency reducing does to it are
    /// not documented: use it to find gaps, and <see cref="Timestamp"/> for time.
    /// </summary>
    public abstract uint? FrameIndex { get; }

    /// <summary>All values behind the header, in wire order, bit for bit as received. Valid as long as the frame.</summary>
    public ReadOnlySpan<float> Values => _data.Values;

    /// <summary>When the bytes that completed the frame were received: ticks of <see cref="Stopwatch"/>, a clock that never jumps.</summary>
    public long Timestamp => _data.WhileValid(_timestamp);

    /// <summary>Time since the frame was received.</summary>
    public TimeSpan Age => TimeSpan.FromSeconds((Stopwatch.GetTimestamp() - Timestamp) / (double)Stopwatch.Frequency);

    /// <summary>
    /// Which server the frame came from: over UDP, 0 for the first one that sent, 1 for the next one; always 0 over TCP.
    /// Two servers may use the same <see cref="AvatarIndex"/>. A server keeps its number when it restarts on another port of the same address.
    /// </summary>
    public int Source => _data.WhileValid(PacketOrigin.SourceOf(Origin));

    // The source, and which sender of it: another one may count its frames from anywhere.
    internal int Origin { get; private protected set; }

    // Header and values. Of a line of text, what TextLine made of it.
    internal ReadOnlySpan<byte> Packet => _data.Packet;

    internal bool WasReadLate => _data.WasReadLate;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void Borrow(in ReceivedPacket packet)
    {
        _data.Borrow(packet.Array, packet.Offset, packet.Length);
        _timestamp = packet.Timestamp;
        Origin = packet.Origin;
        OnData();
    }

    // When whoever the frame was lent to has had it.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void Expire() => _data.Expire();

    // Header fields are read when asked for: most handlers need few of them.
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
