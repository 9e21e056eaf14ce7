using NeuronMocap.Diagnostics;

namespace NeuronMocap.Tool.Diagnose;

/// <summary>A format of a diagnosis. Throws an <see cref="IOException"/> if writing fails.</summary>
internal abstract class DiagnosisOutput : IProgress<DiagnosisStep>
{
    /// <summary>Called for every step when it ends.</summary>
    public virtual void Report(DiagnosisStep value)
    {
    }

    /// <summary>Called once at the end, after the last step.</summary>
    public abstract void Finish(StreamDiagnosis diagnosis);
}
