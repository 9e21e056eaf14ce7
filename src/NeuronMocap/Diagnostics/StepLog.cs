using System.Diagnostics;

namespace NeuronMocap.Diagnostics;

// The steps of a running diagnosis, each told as it ends.
internal sealed class StepLog(IProgress<DiagnosisStep>? progress)
{
    private readonly List<DiagnosisStep> _steps = [];
    private readonly Stopwatch _watch = Stopwatch.StartNew();
    private TimeSpan _told;

    public IReadOnlyList<DiagnosisStep> Steps => _steps;

    public void Ok(string name, string detail) => Add(name, StepOutcome.Ok, detail);

    public void Warning(string name, string detail) => Add(name, StepOutcome.Warning, detail);

    public void Failed(string name, string detail) => Add(name, StepOutcome.Failed, detail);

    private void Add(string name, StepOutcome outcome, string detail)
    {
        TimeSpan now = _watch.Elapsed;
        var step = new DiagnosisStep(name, outcome, detail, now - _told);
        _told = now;
        _steps.Add(step);
        progress?.Report(step);
    }
}
