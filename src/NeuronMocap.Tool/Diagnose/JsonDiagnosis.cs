using NeuronMocap.Diagnostics;
using NeuronMocap.Tool.Output;

namespace NeuronMocap.Tool.Diagnose;

/// <summary>Writes one JSON object for the result and, unless quiet, one for each step.</summary>
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
