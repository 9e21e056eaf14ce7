using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Convert;

/// <summary>The motion in a file, and the format of its values.</summary>
/// <param name="Motion">The poses. The motion has an end.</param>
/// <param name="Layout">The values of its motion packets.</param>
/// <param name="Order">Its rotation order.</param>
/// <param name="AvatarName">Name of the avatar.</param>
internal sealed record InputTake(MotionSource Motion, ChannelLayout Layout, RotationOrder Order, string AvatarName)
{
    private const string UsualName = "Char00";

    /// <summary>The bones of the file, if it is BVH.</summary>
    public BvhSkeletonMap? Bvh { get; init; }

    /// <summary>The rows, if the file is calculation data.</summary>
    public CalculationDocument? Calculation { get; init; }

    /// <summary>The requested part of the motion.</summary>
    public TimeRange Range { get; init; }

    /// <summary>The first row that arrived in the part, and the number of rows; null if the frames' own times give the part.</summary>
    private (long First, long Count)? Rows { get; init; }

    /// <summary>Loads a file.</summary>
    /// <exception cref="NeuronException">The file has no pose of the 59 bones.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static InputTake Load(FileSettings settings, FileKind kind, IProgress<double> progress, CancellationToken cancellationToken)
    {
        var range = new TimeRange(settings.From, settings.To);
        return kind switch
        {
            FileKind.Bvh => Of(BvhFile.Load(settings.Input, progress, cancellationToken)) with { Range = range },
            FileKind.Calculation => Of(CalculationDocument.Load(settings.Input, settings.ReadCalculation(progress, cancellationToken)), UsualName) with { Range = range },
            _ => OfStream(settings, range, progress, cancellationToken),
        };
    }

    /// <summary>Gets the first frame of the requested part and the number of its frames.</summary>
    /// <exception cref="NeuronException">The part has no frame.</exception>
    public (long First, long Count) GetPart() => Rows ?? Range.FramesOf(Motion);

    public static InputTake Of(BvhDocument document)
    {
        var source = new BvhSource(document);
        BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out _);
        return new InputTake(source, map!.Layout, source.RotationOrder, UsualName) { Bvh = map };
    }

    private static InputTake Of(CalculationDocument document, string avatarName) =>
        new(new CalculationSource(document), new ChannelLayout(hasDisplacement: true, hasReference: false), RotationOrder.YXZ, avatarName) { Calculation = document };

    private static InputTake OfStream(FileSettings settings, TimeRange range, IProgress<double> progress, CancellationToken cancellationToken)
    {
        if (CalculationRows.TryLoad(settings, range, progress, cancellationToken) is { } calculation)
            return Of(calculation.Document, calculation.AvatarName) with { Range = range, Rows = calculation.Rows };

        RecordingSource source = RecordingSource.Load(settings.Input, settings.Avatar, settings.Sender, settings.Playback, progress, cancellationToken);
        return new InputTake(source, source.Layout, source.Format.RotationOrder, source.AvatarName) { Range = range };
    }
}
