using System.Numerics;
using NeuronMocap.Calculation;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>
/// Writes a performance as Axis Neuron exports calculation data: what <see cref="CalculationSynthesizer"/> computes, in metres, with z into the
/// ground and the origin as high as the hips of the standing body, and with four decimals. Rotations are those of bones, as of sensors that sit straight.
/// </summary>
public static class CalculationExport
{
    private const double Scale = 10_000;

    /// <summary>Writes a performance.</summary>
    /// <param name="source">What to write; it has an end.</param>
    /// <param name="writer">Where to; not disposed.</param>
    /// <param name="progress">Is told the number of frames written, every 256 and at the end; null for nobody.</param>
    /// <param name="cancellationToken">Ends the work between two frames.</param>
    /// <exception cref="ArgumentException">The source never ends.</exception>
    /// <exception cref="OperationCanceledException">The work was cancelled.</exception>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public static void Write(
        MotionSource source, CalculationFileWriter writer, IProgress<long>? progress = null, CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(source);
        ArgumentNullException.ThrowIfNull(writer);
        if (source.FrameCount is not { } count)
            throw new ArgumentException("A performance without an end makes no file.", nameof(source));

        float ground = GetHipsHeight(source) / CalculationAxes.CentimetresPerMetre;
        Span<float> values = stackalloc float[writer.ValueCount];
        for (long frame = 0; frame < count; frame++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            CalculationSynthesizer.Write(source, frame, values);
            CalculationAxes.Export.ConvertFromBvh(values);
            Lower(values, ground);
            writer.WriteFrame(values);
            if ((frame + 1) % 256 == 0 || frame + 1 == count)
                progress?.Report(frame + 1);
        }
    }

    private static float GetHipsHeight(MotionSource source)
    {
        Span<Vector3> offsets = stackalloc Vector3[BoneHierarchy.BoneCount];
        Span<Vector3> endSites = stackalloc Vector3[BoneHierarchy.BoneCount];
        source.GetBody(offsets, endSites);
        return offsets[(int)Bone.Hips].Y;
    }

    // z of every position, downwards from the hips' height; and all values as near as four decimals come.
    private static void Lower(Span<float> values, float height)
    {
        const int ValuesPerBone = 16;
        const int FirstContact = CalculationFrame.BodyValueCount - 2;
        for (int i = 0; i < values.Length; i++)
        {
            int inBone = i < FirstContact ? i % ValuesPerBone : (i - 2) % ValuesPerBone;
            if (inBone == 2 && i is not (FirstContact or FirstContact + 1))
                values[i] += height;
            values[i] = (float)(Math.Round(values[i] * Scale) / Scale);
        }
    }
}
