#nullable enable

using System;
using System.IO;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // A source in the window: its state, its buttons, its performers.
    internal sealed class SourcePanel : IDisposable
    {
        public const string Record = "Record";
        public const string StopRecording = "Stop Recording";
        public const string ZeroOutAll = "Zero Out All";

        private readonly MocapSource _source;
        private readonly DiagnosisPanel _diagnosis = new DiagnosisPanel();
        private SourceReport? _report;
        private SourceTake? _take;
        private (string Text, string Problem) _takeState = (string.Empty, string.Empty);
        private ZeroOut? _zeroOut;
        private (Severity Severity, string Text) _zeroOutState;

        public SourcePanel(MocapSource source) => _source = source;

        public bool IsDirty => _diagnosis.IsDirty || _take?.IsRunning == true || _zeroOutState.Severity == Severity.Waiting;

        public SourceTake? Take => _take;

        // Beside Assets, because Unity would import files inside it.
        private static string RecordingFolder => Path.Combine(Path.GetDirectoryName(Application.dataPath) ?? string.Empty, "Recordings");

        // Returns the performer that was clicked, if any.
        public Performer? Draw(Performer? shown)
        {
            // All events of a pass must use the rows of its layout event, even if data arrives in between.
            if (_report is null || Event.current.type == EventType.Layout)
                Refresh();

            SourceReport report = _report!;
            ReportGui.Headline(report.Severity, $"{_source.name}: {report.Title}");
            ReportGui.Message(report.Severity, report.Message);
            foreach (ReportRow row in report.Rows)
                ReportGui.Row(row);

            Performer? chosen = null;
            foreach (PerformerRow row in report.Performers)
            {
                if (ReportGui.Performer(row, row.Performer == shown))
                    chosen = row.Performer;
            }

            DrawButtons();
            if (_source.Kind == SourceKind.Network)
                _diagnosis.Draw(_source);

            return chosen;
        }

        public void Dispose()
        {
            _diagnosis.Dispose();
            _take?.Dispose();
            _zeroOut?.Dispose();
        }

        private void Refresh()
        {
            _report = SourceReport.Of(_source, Application.isPlaying);
            _take?.Update();
            _takeState = _take is { } take ? (take.Describe(), take.Problem) : (string.Empty, string.Empty);
            _zeroOutState = _zeroOut is { } zero ? (zero.Severity, zero.Describe()) : default;
        }

        private void DrawButtons()
        {
            using (new EditorGUILayout.HorizontalScope())
            {
                PreviewButton.Draw(_source);
                if (GUILayout.Button("Select"))
                    Selection.activeGameObject = _source.gameObject;

                bool isRecording = _take?.IsRunning == true;
                TakeSettings settings = TakeSettings.instance;
                bool canRecord = _source.Reader is { } && (settings.Clips || SourceTake.FormatsOf(_source, settings) != TakeFormats.None);
                using (new EditorGUI.DisabledScope(!isRecording && !canRecord))
                {
                    if (GUILayout.Button(isRecording ? StopRecording : Record))
                        ToggleRecording();
                }

                using (new EditorGUI.DisabledScope(_source.Kind != SourceKind.Network || _source.CommandPort <= 0 || _zeroOutState.Severity == Severity.Waiting))
                {
                    if (GUILayout.Button(new GUIContent(ZeroOutAll, "Asks the server to zero out all avatars. Whether that changes the direction, the position or both is not documented. Needs the command port.")))
                        _zeroOut = new ZeroOut(_source.Address, _source.CommandPort, avatar: null);
                }
            }

            ReportGui.Message(Severity.None, _takeState.Text);
            ReportGui.Message(Severity.Error, _takeState.Problem);
            if (!string.IsNullOrEmpty(_zeroOutState.Text))
                ReportGui.Message(_zeroOutState.Severity, _zeroOutState.Text);
        }

        private void ToggleRecording()
        {
            if (_take?.IsRunning == true)
                _take.Stop();
            else
                _take = new SourceTake(_source, TakeSettings.instance, RecordingFolder);
        }
    }
}
