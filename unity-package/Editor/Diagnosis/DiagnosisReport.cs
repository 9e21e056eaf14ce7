#nullable enable

using System.Collections.Generic;
using System.Linq;
using NeuronMocap.Diagnostics;

namespace NeuronMocap.Unity.EditorTools
{
    // The current view of a diagnosis: its steps so far, and the verdict at the end.
    internal sealed class DiagnosisReport
    {
        private DiagnosisReport(Severity severity, string title, string text, IReadOnlyList<ReportRow> steps)
        {
            Severity = severity;
            Title = title;
            Text = text;
            Steps = steps;
        }

        public Severity Severity { get; }

        public string Title { get; }

        // The paragraph with the advice. Empty while the diagnosis runs.
        public string Text { get; }

        public IReadOnlyList<ReportRow> Steps { get; }

        public static DiagnosisReport Of(DiagnosisJob job)
        {
            ReportRow[] steps = job.GetSteps().Select(step => new ReportRow(step.Name, step.Detail, Of(step.Outcome))).ToArray();
            if (job.Result is { } result)
                return new DiagnosisReport(Of(result), result.Title, result.Summary, steps);
            if (job.Failure is { } failure)
                return new DiagnosisReport(Severity.Error, "The settings are not valid", failure, steps);
            if (job.IsCancelled)
                return new DiagnosisReport(Severity.None, "Cancelled", string.Empty, steps);

            return new DiagnosisReport(Severity.Waiting, $"Looking for frames from {job.Target}", string.Empty, steps);
        }

        private static Severity Of(StreamDiagnosis result) =>
            !result.IsReceiving ? Severity.Error
            : result.Verdict == DiagnosisVerdict.Receiving ? Severity.Good
            : Severity.Warning;

        private static Severity Of(StepOutcome outcome) => outcome switch
        {
            StepOutcome.Ok => Severity.Good,
            StepOutcome.Warning => Severity.Warning,
            _ => Severity.Error,
        };
    }
}
