using NeuronMocap.Calculation;
using NeuronMocap.Server;

namespace NeuronMocap.Tests.Calculation;

// A calculation export of the synthetic actor, with the centres of the bones, as Axis Neuron writes it.
internal static class ActorExport
{
    public static CalculationDocument Write(int frames, bool stands = false)
    {
        var actor = new SyntheticSource(120);
        using var text = new MemoryStream();
        using (var writer = new CalculationFileWriter(text, CalculationFrame.FullValueCount, leaveOpen: true))
        {
            float[] values = new float[writer.ValueCount];
            for (int frame = 0; frame < frames; frame++)
            {
                CalculationSynthesizer.Write(actor, stands ? 0 : frame, values);
                CalculationAxes.Export.ConvertFromBvh(values);
                writer.WriteFrame(values);
            }
        }

        return CalculationDocument.Parse(text.ToArray());
    }
}
