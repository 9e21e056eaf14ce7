using System.Numerics;
using NeuronMocap.Calculation;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>Writes a source as a calculation export of Axis Neuron.</summary>
/// <remarks>
/// The values are those of <see cref="CalculationSynthesizer"/>, with four decimals. Positions are in metres. Z points into the ground, and the
/// origin is at the height of the hips of the standing body. Sensor rotations are those of the bones, as if all sensors sat straight.
/// </remarks>
public static class CalculationExport
{
    private const double Scale = 10_000;

    /// <summary>Writes a source.</summary>
    /// <param name="source">The source to write. It must have an end.</param>
    /// <param name="writer">The writer to write to. It is not disposed.</param>
    /// <param name="progress">Receives the number of written frames, every 256 frames and at the end; may be null.</param>
    /// <param name="cancellationToken">Cancels the work between two frames.</param>
    /// <exception cref="ArgumentException">The source never ends.</exception>
    /// <exception cref="OperationCanceledException">The work was cancelled.</exception>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public static void Write(
        MotionSource source, CalculationFileWriter writer, IProgress<long>? progress = null, CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(source);
        ArgumentNullException.ThrowIfNull(writer);
        if (source.FrameCount is not { } count)
            throw new ArgumentException("The source must have an end.", nameof(source));

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

    // Converts z of every position to downwards from the height of the hips, and rounds all values to four decimals.
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
