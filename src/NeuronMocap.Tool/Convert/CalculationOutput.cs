using NeuronMocap.Calculation;
using NeuronMocap.Server;

namespace NeuronMocap.Tool.Convert;

/// <summary>Writes a take as a calculation export, with the values that sensors would have measured, in the axes of Axis Neuron's exports.</summary>
internal static class CalculationOutput
{
    public static void Write(MotionSource take, Stream output, IProgress<double> progress, CancellationToken cancellationToken)
    {
        using var writer = new CalculationFileWriter(
            output, CalculationFrame.FullValueCount, CalculationTextFormat.AxisNeuron.WithFrameRate(take.FrameRate));
        float[] values = new float[writer.ValueCount];
        long count = take.FrameCount!.Value;
        for (long frame = 0; frame < count; frame++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            CalculationSynthesizer.Write(take, frame, values);
            CalculationAxes.Export.ConvertFromBvh(values);
            writer.WriteFrame(values);
            progress.Report((double)frame / count);
        }
    }
}
