using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Convert;

namespace NeuronMocap.Tool.Files;

/// <summary>The performance that a file holds, and how its values are laid out there.</summary>
/// <param name="Motion">The poses; it ends.</param>
/// <param name="Layout">Which values a motion packet of it has.</param>
/// <param name="Order">Order of its rotation values.</param>
/// <param name="AvatarName">Who performs.</param>
internal sealed record InputTake(MotionSource Motion, ChannelLayout Layout, RotationOrder Order, string AvatarName)
{
    private const string UsualName = "Char00";

    /// <summary>The file, where it is BVH.</summary>
    public BvhDocument? Bvh { get; init; }

    /// <summary>The rows, where it is calculation data.</summary>
    public CalculationDocument? Calculation { get; init; }

    /// <summary>Reads a file.</summary>
    /// <exception cref="NeuronException">There is no pose of the 59 bones in it.</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static InputTake Load(FileSettings settings, FileKind kind, IProgress<double> progress, CancellationToken cancellationToken) => kind switch
    {
        FileKind.Bvh => Of(BvhFile.Load(settings.Input, progress, cancellationToken)),
        FileKind.Calculation => Of(CalculationDocument.Load(settings.Input, settings.ReadCalculation(progress, cancellationToken)), UsualName),
        _ => OfStream(settings, progress, cancellationToken),
    };

    public static InputTake Of(BvhDocument document)
    {
        var source = new BvhSource(document);
        BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out _);
        return new InputTake(source, map!.Layout, source.RotationOrder, UsualName) { Bvh = document };
    }

    private static InputTake Of(CalculationDocument document, string avatarName) =>
        new(new CalculationSource(document), new ChannelLayout(hasDisplacement: true, hasReference: false), RotationOrder.YXZ, avatarName) { Calculation = document };

    private static InputTake OfStream(FileSettings settings, IProgress<double> progress, CancellationToken cancellationToken)
    {
        if (CalculationRows.TryLoad(settings, progress, cancellationToken) is { } calculation)
            return Of(calculation.Document, calculation.AvatarName);

        RecordingSource source = RecordingSource.Load(settings.Input, settings.Avatar, settings.Playback, progress, cancellationToken);
        return new InputTake(source, source.Layout, source.Format.RotationOrder, source.AvatarName);
    }
}
