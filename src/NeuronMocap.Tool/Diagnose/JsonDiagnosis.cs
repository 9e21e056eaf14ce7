using NeuronMocap.Diagnostics;
using NeuronMocap.Tool.Output;

namespace NeuronMocap.Tool.Diagnose;

/// <summary>One JSON object for each step, unless it is to be quiet, and one for the result.</summary>
internal sealed class JsonDiagnosis(Stream output, bool quiet) : DiagnosisOutput
{
    private readonly JsonLines _lines = new();

    public override void Report(DiagnosisStep value)
    {
        if (!quiet)
            output.Write(_lines.Step(value));
    }

    public override void Finish(StreamDiagnosis diagnosis) => output.Write(_lines.Diagnosis(diagnosis));
}
