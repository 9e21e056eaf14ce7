using System.Numerics;
using NeuronMocap.Calculation;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>
/// A take from a calculation export. Its poses are what <see cref="CalculationSkeleton"/> makes of bones' centres and sensors; foot contacts are the
/// file's own, and so are the values of calculation packets, bit for bit, with <see cref="WriteCalculation"/>.
/// </summary>
public sealed class CalculationSource : MotionSource
{
    private readonly CalculationDocument _document;

    /// <summary>Makes a source of a file.</summary>
    /// <param name="document">The file.</param>
    /// <param name="axes">The file's axes; null is the same as <see cref="CalculationAxes.Export"/>.</param>
    /// <exception cref="CalculationFormatException">The file has the ends of the bones instead of their centres.</exception>
    public CalculationSource(CalculationDocument document, CalculationAxes? axes = null)
    {
        ArgumentNullException.ThrowIfNull(document);
        _document = document;
        Skeleton = CalculationSkeleton.Measure(document, axes);
    }

    /// <summary>The skeleton that was found behind the take.</summary>
    public CalculationSkeleton Skeleton { get; }

    /// <inheritdoc/>
    public override double FrameRate => _document.FrameRate;

    /// <inheritdoc/>
    public override long? FrameCount => _document.FrameCount;

    /// <summary>Always true: feet that the server held to the ground are where they were recorded.</summary>
    public override bool HasDisplacement => true;

    /// <inheritdoc/>
    public override SkeletonVariant Variant => Skeleton.Body.Variant;

    /// <summary>Values of the file's rows, 946 or 338: for <see cref="BroadcasterOptions.CalculationValueCount"/>.</summary>
    public int ValueCount => _document.ValueCount;

    /// <inheritdoc/>
    public override void GetPose(long frame, Span<BoneTransform> pose) =>
        Skeleton.CopyLocalTransforms(_document.GetValues(checked((int)frame)), pose);

    /// <summary>Which feet are on the ground, as the file has it.</summary>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <returns>True for each foot that touches.</returns>
    public override FootContacts GetFootContacts(long frame) => _document.GetFootContacts(checked((int)frame));

    /// <inheritdoc/>
    public override void GetBody(Span<Vector3> offsets, Span<Vector3> endSites)
    {
        Skeleton.Body.Offsets.CopyTo(offsets);
        Skeleton.Body.EndSites.CopyTo(endSites);
    }

    /// <summary>
    /// Writes the file's own values of a frame, for <see cref="BroadcasterOptions.Calculation"/>. A turn of <see cref="Broadcaster.ZeroOut"/> is not in
    /// them; where the take is repeated, frame numbers go on.
    /// </summary>
    /// <param name="source">The avatar's performance; not looked at.</param>
    /// <param name="frame">Frame number, from 0.</param>
    /// <param name="values">Room for 946 values, all of which are written: of a file without fingers theirs are zero.</param>
    public void WriteCalculation(MotionSource source, long frame, Span<float> values)
    {
        values.Clear();
        _document.GetValues((int)(frame % _document.FrameCount)).CopyTo(values);
    }
}
