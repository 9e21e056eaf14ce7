using NeuronMocap.Protocol;
using NeuronMocap.Server.Faults;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>
/// The content of every frame of a stream: for each avatar in turn a motion packet, a calculation packet, or both.
/// </summary>
/// <remarks>A line of text counts as a packet. Immutable; all threads share it.</remarks>
internal sealed class FramePlan : BroadcastContent
{
    private readonly BroadcastFormat _format;

    public FramePlan(BroadcasterOptions options, IReadOnlyList<AvatarName> names, double rate, bool hasMotion, bool hasCalculation)
    {
        HasMotion = hasMotion;
        HasCalculation = hasCalculation;
        _format = options.Format;
        Sources = options.Sources;
        Names = names;
        Layout = new ChannelLayout(options.IncludeDisplacement ?? options.Sources[0].HasDisplacement, options.IncludeReference);
        Order = options.RotationOrder;
        Version = options.DataVersion ?? (_format == BroadcastFormat.Studio ? DataVersion.Studio : DataVersion.New);
        FrameRate = rate;
        Calculation = options.Calculation;
        StudioCalculation = options.StudioCalculation;
        CalculationValueCount = options.CalculationValueCount;
        TextDecimals = options.TextDecimals;
        TextQuirks = options.TextQuirks;
        WritesInPlace = _format != BroadcastFormat.Text && options.Fragment is null && BitConverter.IsLittleEndian;
        FrameCount = Math.Min(options.MaxFrames ?? long.MaxValue, options.Sources.Min(source => source.FrameCount ?? long.MaxValue));
        MaxMotionSize = HasMotion ? MeasureMotion() : 0;
        MaxCalculationSize = HasCalculation ? MeasureCalculation() : 0;
    }

    public IReadOnlyList<MotionSource> Sources { get; }

    public IReadOnlyList<AvatarName> Names { get; }

    public ChannelLayout Layout { get; }

    public RotationOrder Order { get; }

    // Version of the motion packets. Text carries no version.
    public DataVersion Version { get; }

    // Frame rate of the timecode: that of the broadcast, or of the first source if the broadcast is not paced.
    public double FrameRate { get; }

    public CalculationProvider? Calculation { get; }

    public StudioCalculationProvider? StudioCalculation { get; }

    // 946, or 338 for the body alone. The shorter form is the start of the longer one (CalculationFrame.BodyValueCount).
    public int CalculationValueCount { get; }

    public int TextDecimals { get; }

    public TextQuirks TextQuirks { get; }

    // Whether sources write values where the packet needs them. Without fragments, every packet starts at a multiple of four bytes.
    public bool WritesInPlace { get; }

    // Frames are counted from 0. long.MaxValue when the broadcast never ends.
    public long FrameCount { get; }

    // Maximum size of a motion packet. Unless it is text, every motion packet has this size. 0 without motion packets.
    public int MaxMotionSize { get; }

    // Maximum size of a calculation packet. 0 without calculation packets.
    public int MaxCalculationSize { get; }

    public override bool HasMotion { get; }

    public override bool HasCalculation { get; }

    public override int AvatarCount => Sources.Count;

    public override int PacketsPerFrame => AvatarCount * (HasMotion && HasCalculation ? 2 : 1);

    public override int MaxFrameSize => AvatarCount * (MaxMotionSize + MaxCalculationSize);

    public override FrameFeed CreateFeed(bool isSingle) => new TakeFeed(this);

    public FrameEncoder CreateEncoder() => _format switch
    {
        BroadcastFormat.Text => new TextFrameEncoder(this),
        BroadcastFormat.Studio => new StudioFrameEncoder(this),
        _ => new BinaryFrameEncoder(this),
    };

    public override int MeasurePacket(ReadOnlySpan<byte> frames, bool isMotion)
    {
        if (_format == BroadcastFormat.Text)
            return frames.IndexOf((byte)'\n') + 1;

        return isMotion ? MaxMotionSize : MaxCalculationSize;
    }

    private int MeasureMotion() => _format == BroadcastFormat.Text
        ? TextFrameEncoder.MaxMotionSize(this)
        : ProtocolConstants.HeaderSize + (Layout.ValueCount * sizeof(float));

    private int MeasureCalculation() => _format switch
    {
        BroadcastFormat.Text => TextFrameEncoder.MaxCalculationSize(this),
        BroadcastFormat.Studio => ProtocolConstants.HeaderSize + StudioCalculationSynthesizer.PayloadSize,
        _ => ProtocolConstants.HeaderSize + (CalculationValueCount * sizeof(float)),
    };
}
