using System.Diagnostics;

namespace NeuronMocap.Diagnostics;

// The steps of a running diagnosis. Each step is reported when it ends.
internal sealed class StepLog(IProgress<DiagnosisStep>? progress)
{
    private readonly List<DiagnosisStep> _steps = [];
    private readonly Stopwatch _watch = Stopwatch.StartNew();
    private TimeSpan _lastStep;

    public IReadOnlyList<DiagnosisStep> Steps => _steps;

    // Creates a log for another part of the same diagnosis; its steps have a prefix in their names.
    public StepLog With(string prefix) => new(new Relay(this, prefix));

    public void Ok(string name, string detail) => Add(name, StepOutcome.Ok, detail);

    public void Warning(string name, string detail) => Add(name, StepOutcome.Warning, detail);

    public void Failed(string name, string detail) => Add(name, StepOutcome.Failed, detail);

    private void Add(string name, StepOutcome outcome, string detail)
    {
        TimeSpan now = _watch.Elapsed;
        var step = new DiagnosisStep(name, outcome, detail, now - _lastStep);
        _lastStep = now;
        _steps.Add(step);
        progress?.Report(step);
    }

    private sealed class Relay(StepLog log, string prefix) : IProgress<DiagnosisStep>
    {
        public void Report(DiagnosisStep value) => log.Add(prefix + value.Name, value.Outcome, value.Detail);
    }
}
