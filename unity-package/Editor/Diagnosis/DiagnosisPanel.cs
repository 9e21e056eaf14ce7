#nullable enable

using System;
using NeuronMocap.Diagnostics;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // The button that asks why nothing arrives, the steps of the diagnosis, and the answer. Nothing blocks: the window repaints until the diagnosis
    // is done.
    internal sealed class DiagnosisPanel : IDisposable
    {
        public const string Ask = "Why Is Nothing Arriving?";
        public const string Cancel = "Cancel";

        private DiagnosisJob? _job;
        private DiagnosisReport? _report;
        private PausedSources? _paused;

        // Options of the diagnosis; null for the library's defaults.
        internal static DiagnosisOptions? Options { get; set; }

        public bool IsRunning => _job?.IsRunning == true;

        // True until a repaint has shown the answer and resumed the paused sources.
        public bool IsDirty => _job is not null && (_report is null || _report.Severity == Severity.Waiting);

        public DiagnosisJob? Job => _job;

        public void Draw(MocapSource source)
        {
            if (Event.current.type == EventType.Layout)
                Refresh();

            using (new EditorGUILayout.HorizontalScope())
            {
                using (new EditorGUI.DisabledScope(IsRunning))
                {
                    if (GUILayout.Button(Ask))
                        Start(source);
                }

                if (_report?.Severity == Severity.Waiting && GUILayout.Button(Cancel, GUILayout.Width(70f)))
                    _job?.Cancel();
            }

            if (_report is not { } report)
                return;

            ReportGui.Headline(report.Severity, report.Title);
            foreach (ReportRow step in report.Steps)
                ReportGui.Step(step);

            ReportGui.Message(report.Severity, report.Text);
        }

        public void Dispose()
        {
            AssemblyReloadEvents.beforeAssemblyReload -= Dispose;
            _job?.Dispose();
            Resume();
        }

        private void Start(MocapSource source)
        {
            // Work in the pool would continue in the old domain.
            AssemblyReloadEvents.beforeAssemblyReload -= Dispose;
            AssemblyReloadEvents.beforeAssemblyReload += Dispose;
            NeuronReaderOptions options = DiagnosisRequest.OptionsOf(source);
            _paused = PausedSources.SharingUdpPort(options);
            _job = new DiagnosisJob(options, SourceConnections.Closed, Options);
            _report = null;
        }

        private void Refresh()
        {
            if (_job is null)
                return;

            _report = DiagnosisReport.Of(_job);
            if (!_job.IsRunning)
                Resume();
        }

        private void Resume()
        {
            _paused?.Dispose();
            _paused = null;
        }
    }
}
