using System.Diagnostics;
using System.Runtime.CompilerServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Frames;

/// <summary>
/// One avatar at one instant, as it came off the wire: what motion and calculation frames have in common.
/// <para>
/// A frame that a callback, a queue or a newest-frame slot hands out is only lent: its memory is used again for later frames, so it is valid
/// as long as the member that gave it says, on that thread. <c>Clone</c> makes one to keep.
/// </para>
/// </summary>
public abstract class AvatarFrame
{
    private protected FrameData _data;

    private protected AvatarFrame()
    {
    }

    /// <summary>Number of the avatar on the server, from 0. The 32 bits of the header as an int: negative from 2³¹ on.</summary>
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
    public long Timestamp { get; private protected set; }

    /// <summary>Time since the frame was received.</summary>
    public TimeSpan Age => TimeSpan.FromSeconds((Stopwatch.GetTimestamp() - Timestamp) / (double)Stopwatch.Frequency);

    /// <summary>
    /// Which sender the frame came from: over UDP, 0 for the first address that sent to the port, 1 for the next one; always 0 over TCP.
    /// Two senders may use the same <see cref="AvatarIndex"/>.
    /// </summary>
    public int Source { get; private protected set; }

    // Header and values. Of a line of text, what TextLine made of it.
    internal ReadOnlySpan<byte> Packet => _data.Packet;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void Borrow(in ReceivedPacket packet)
    {
        _data.Borrow(packet.Array, packet.Offset, packet.Length);
        Timestamp = packet.Timestamp;
        Source = packet.Source;
        OnData();
    }

    // Header fields are read when asked for: most handlers need few of them.
    private protected virtual void OnData()
    {
    }

    private protected void CopyFrom(AvatarFrame other)
    {
        _data.Copy(other._data.Packet);
        Timestamp = other.Timestamp;
        Source = other.Source;
        OnData();
    }
}
