using NeuronMocap.Diagnostics;

namespace NeuronMocap.Tool.Diagnose;

/// <summary>A way of showing a diagnosis. What cannot be written throws an <see cref="IOException"/>.</summary>
internal abstract class DiagnosisOutput : IProgress<DiagnosisStep>
{
    /// <summary>Called for every step as it ends.</summary>
    public virtual void Report(DiagnosisStep value)
    {
    }

    /// <summary>Called once at the end, after the last step.</summary>
    public abstract void Finish(StreamDiagnosis diagnosis);
}
