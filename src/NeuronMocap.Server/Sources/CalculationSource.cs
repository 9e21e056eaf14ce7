using System.Numerics;
using NeuronMocap.Calculation;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>A source that plays a take from a calculation export.</summary>
/// <remarks>
/// <see cref="CalculationSkeleton"/> computes the poses from the centres of the bones and the sensors. Foot contacts are those of the file.
/// <see cref="WriteCalculation"/> writes the calculation values of the file bit for bit.
/// </remarks>
public sealed class CalculationSource : MotionSource
{
    private readonly CalculationDocument _document;

    /// <summary>Creates a source from a file.</summary>
    /// <param name="document">The file.</param>
    /// <param name="axes">The axes of the file; null for <see cref="CalculationAxes.Export"/>.</param>
    /// <exception cref="CalculationFormatException">
    /// The file holds the ends of the bones instead of their centres, or each frame has a position that is not a number.
    /// </exception>
    public CalculationSource(CalculationDocument document, CalculationAxes? axes = null)
    {
        ArgumentNullException.ThrowIfNull(document);
        _document = document;
        Skeleton = CalculationSkeleton.Measure(document, axes);
    }

    /// <summary>The skeleton that was computed from the take.</summary>
    public CalculationSkeleton Skeleton { get; }

    /// <inheritdoc/>
    public override double FrameRate => _document.FrameRate;

    /// <inheritdoc/>
    public override long? FrameCount => _document.FrameCount;

    /// <summary>Always true. Feet that the server held to the ground are where they were recorded.</summary>
    public override bool HasDisplacement => true;

    /// <inheritdoc/>
    public override SkeletonVariant Variant => Skeleton.Body.Variant;

    /// <summary>Number of values in a row of the file, 946 or 338. Use it for <see cref="BroadcasterOptions.CalculationValueCount"/>.</summary>
    public int ValueCount => _document.ValueCount;

    /// <inheritdoc/>
    public override void GetPose(long frame, Span<BoneTransform> pose) =>
        Skeleton.CopyLocalTransforms(_document.GetValues(checked((int)frame)), pose);

    /// <summary>Gets which feet touch the ground, as recorded in the file.</summary>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <returns>True for each foot that touches the ground.</returns>
    public override FootContacts GetFootContacts(long frame) => _document.GetFootContacts(checked((int)frame));

    /// <inheritdoc/>
    public override void GetBody(Span<Vector3> offsets, Span<Vector3> endSites)
    {
        Skeleton.Body.Offsets.CopyTo(offsets);
        Skeleton.Body.EndSites.CopyTo(endSites);
    }

    /// <summary>Writes the values of a frame as they are in the file, for <see cref="BroadcasterOptions.Calculation"/>.</summary>
    /// <remarks>
    /// The values do not include turns of <see cref="Broadcaster.ZeroOut"/>. When the take is repeated, the frame numbers continue.
    /// </remarks>
    /// <param name="source">The source of the avatar, which is not used.</param>
    /// <param name="frame">Frame number, from 0.</param>
    /// <param name="values">Room for 946 values. All are written; if the file has no fingers, their values are zero.</param>
    public void WriteCalculation(MotionSource source, long frame, Span<float> values)
    {
        values.Clear();
        _document.GetValues((int)(frame % _document.FrameCount)).CopyTo(values);
    }
}
