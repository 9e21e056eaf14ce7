using System.Diagnostics;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap.Diagnostics;

// The frames of one kind, of one avatar, of one sender during a diagnosis. The receive loop writes; other code reads after its end.
internal sealed class AvatarSample(PacketKind kind, int sender, uint index)
{
    // With fewer frames, neither the rate nor a lack of motion is significant.
    private const int MinFrames = 5;

    private const int FramesToBegin = 10;

    private readonly IndexTracker _tracker = new();
    private byte[] _lastValues = [];
    private uint? _lastIndex;
    private long _first;
    private long _begun;
    private long _last;
    private long _longest;
    private long _sameValues;
    private long _sameIndex;

    public PacketKind Kind => kind;

    public int Sender => sender;

    public uint Index => index;

    public AvatarName Name { get; private set; }

    public DataVersion Version { get; private set; }

    public int ValueCount { get; private set; }

    public bool HasDisplacement { get; private set; }

    public bool HasReference { get; private set; }

    public long Frames { get; private set; }

    // Ignores the first frames: the server may have kept them for a new client, and they wait while this side gets ready.
    public double FrameRate => Frames switch
    {
        >= 3 * FramesToBegin => PerSecond(Frames - FramesToBegin, _begun),
        >= MinFrames => PerSecond(Frames - 1, _first),
        _ => 0,
    };

    public TimeSpan LongestGap => PreciseTime.FromSeconds(_longest / (double)Stopwatch.Frequency);

    // The step of the frame index from frame to frame. It is more than 1 if the server sends every second or third frame but counts all of them.
    public int Step => _tracker.Step;

    // The same count as in a reader.
    public long Lost => _tracker.Lost - _tracker.Unsettled;

    public bool IsMotionless => Frames >= MinFrames && (_sameValues == Frames - 1 || _sameIndex == Frames - 1);

    public void OnFrame(in ReceivedPacket packet)
    {
        if (kind == PacketKind.Motion)
            Read(MotionHeader.Read(packet.Bytes));
        else if (kind == PacketKind.Calculation)
            Read(CalculationHeader.Read(packet.Bytes));
        else
            Read(StudioCalculationHeader.Read(packet.Bytes));

        ReadOnlySpan<byte> values = packet.Bytes[ProtocolConstants.HeaderSize..];
        if (Frames == 0)
            _first = packet.Timestamp;
        else
            Compare(values, packet.Timestamp);

        if (_lastValues.Length != values.Length)
            _lastValues = new byte[values.Length];

        values.CopyTo(_lastValues);
        _last = packet.Timestamp;
        if (++Frames == FramesToBegin)
            _begun = _last;
    }

    public DiagnosedAvatar ToPublic() => new()
    {
        Kind = kind,
        Index = (int)index,
        Name = Name.ToString(),
        Version = Version,
        ValueCount = ValueCount,
        HasDisplacement = HasDisplacement,
        HasReference = HasReference,
        Frames = Frames,
        Lost = Lost,
        FrameRate = FrameRate,
        LongestGap = LongestGap,
    };

    private double PerSecond(long intervals, long since) => _last > since ? intervals * (double)Stopwatch.Frequency / (_last - since) : 0;

    private void Compare(ReadOnlySpan<byte> values, long timestamp)
    {
        _longest = Math.Max(_longest, timestamp - _last);
        if (values.SequenceEqual(_lastValues))
            _sameValues++;
    }

    private void Read(in MotionHeader header)
    {
        (Name, Version, ValueCount) = (header.AvatarName, header.Version, header.ValueCount);
        (HasDisplacement, HasReference) = (header.HasDisplacement, header.HasReference);
        Count(header.FrameIndex);
    }

    private void Read(in CalculationHeader header)
    {
        (Name, Version, ValueCount) = (header.AvatarName, header.Version, header.ValueCount);
        Count(Version == DataVersion.None ? null : header.FrameIndex);
    }

    private void Read(in StudioCalculationHeader header)
    {
        (Name, Version, ValueCount) = (header.AvatarName, header.Version, header.ByteCount / sizeof(float));
        Count(header.FrameIndex);
    }

    private void Count(uint? frameIndex)
    {
        if (frameIndex is not null && frameIndex == _lastIndex)
            _sameIndex++;

        _tracker.OnIndex(frameIndex);
        _lastIndex = frameIndex;
    }
}
