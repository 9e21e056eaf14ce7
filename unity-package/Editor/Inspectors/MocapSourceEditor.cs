#nullable enable

using System.Linq;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // The relevant fields, and below them what arrives, or why nothing arrives.
    [CustomEditor(typeof(MocapSource))]
    [CanEditMultipleObjects]
    internal sealed class MocapSourceEditor : Editor
    {
        public const string Browse = "Browse...";

        private readonly DiagnosisPanel _diagnosis = new DiagnosisPanel();
        private RepaintTimer? _timer;
        private DelayPicture? _picture;
        private SourceReport[] _reports = System.Array.Empty<SourceReport>();

        internal DiagnosisPanel Diagnosis => _diagnosis;

        public override void OnInspectorGUI()
        {
            MocapSource[] sources = targets.Cast<MocapSource>().ToArray();
            DrawFields(sources);

            // All events of a pass must use the rows of its layout event, even if data arrives in between.
            if (Event.current.type == EventType.Layout || _reports.Length != sources.Length)
                _reports = sources.Select(source => SourceReport.Of(source, Application.isPlaying)).ToArray();

            EditorGUILayout.Space();
            if (sources.Length == 1)
                DrawReport(sources[0], _reports[0]);
            else
                DrawSummaries(sources);
        }

        private void OnEnable()
        {
            _picture = new DelayPicture(() => target is MocapSource source && source != null ? source.Performers.FirstOrDefault() : null, isOpen: false);
            _timer = new RepaintTimer(() => Application.isPlaying || LivePreview.IsOn || _diagnosis.IsDirty, Repaint);
        }

        private void OnDisable()
        {
            _picture?.Dispose();
            _timer?.Dispose();
            _diagnosis.Dispose();
        }

        private void DrawFields(MocapSource[] sources)
        {
            serializedObject.Update();
            int? preset = SourcePresets.Draw(sources);
            FieldDrawing.Draw(serializedObject, SourceFields.HiddenFor(sources).Contains, property =>
            {
                if (property.name is "_file" && GUILayout.Button(Browse))
                    MotionFilePanel.Choose(property, sources[0].Kind == SourceKind.BvhFile ? "bvh" : "nmrec");
            });
            serializedObject.ApplyModifiedProperties();
            if (preset is { } chosen)
                SourcePresets.Apply(chosen, sources);
        }

        private void DrawReport(MocapSource source, SourceReport report)
        {
            ReportGui.Headline(report.Severity, report.Title);
            ReportGui.Message(report.Severity, report.Message);
            PreviewButton.Draw(source);
            foreach (ReportRow row in report.Rows)
                ReportGui.Row(row);

            foreach (PerformerRow row in report.Performers)
                ReportGui.Row(new ReportRow($"{row.Name} ({row.AvatarIndex})", row.Summary, row.Severity));

            _picture!.DrawBuffer(source);
            if (source.Kind != SourceKind.Network)
                return;

            BackgroundAdvice.Draw();
            _diagnosis.Draw(source);
        }

        private void DrawSummaries(MocapSource[] sources)
        {
            for (int i = 0; i < sources.Length; i++)
                ReportGui.Headline(_reports[i].Severity, $"{sources[i].name}: {_reports[i].Title}");
        }
    }
}
