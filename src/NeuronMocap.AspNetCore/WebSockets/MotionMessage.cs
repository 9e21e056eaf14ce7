using System.Net.WebSockets;

namespace NeuronMocap.AspNetCore;

/// <summary>One frame in one form. All clients of the form share it; the last one to release it returns it to its pool.</summary>
internal sealed class MotionMessage(MessagePool pool)
{
    private byte[] _bytes = [];
    private int _length;
    private int _references;

    public ReadOnlyMemory<byte> Bytes => _bytes.AsMemory(0, _length);

    public WebSocketMessageType Type { get; private set; }

    // Frames with the same key replace each other.
    public (int Sender, int Avatar, PacketKind Kind) Key { get; private set; }

    public uint? FrameIndex { get; private set; }

    public long Timestamp { get; private set; }

    // The message that must precede this one; null if there is none.
    public byte[]? Skeleton { get; set; }

    /// <summary>Describes a frame. The caller has the only reference, and fills the message.</summary>
    public void Begin(AvatarFrame frame, WebSocketMessageType type)
    {
        _references = 1;
        Type = type;
        PacketKind kind = frame switch
        {
            MotionFrame => PacketKind.Motion,
            CalculationFrame => PacketKind.Calculation,
            _ => PacketKind.StudioCalculation,
        };
        (Key, FrameIndex, Timestamp, Skeleton) = ((frame.Sender, frame.AvatarIndex, kind), frame.FrameIndex, frame.Timestamp, null);
    }

    public Span<byte> Reserve(int length)
    {
        if (_bytes.Length < length)
            _bytes = new byte[length + (length / 8)];

        _length = length;
        return _bytes.AsSpan(0, length);
    }

    public void Trim(int length) => _length = length;

    public void AddReference() => Interlocked.Increment(ref _references);

    public void Release()
    {
        if (Interlocked.Decrement(ref _references) == 0)
            pool.Return(this);
    }
}

/// <summary>Messages that are not in use. Thread-safe.</summary>
internal sealed class MessagePool
{
    private const int Capacity = 1024;

    private readonly Stack<MotionMessage> _free = new();

    public MotionMessage Rent()
    {
        lock (_free)
            return _free.TryPop(out MotionMessage? message) ? message : new MotionMessage(this);
    }

    public void Return(MotionMessage message)
    {
        lock (_free)
        {
            if (_free.Count < Capacity)
                _free.Push(message);
        }
    }
}
