#nullable enable

using System.IO;
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

        private void OnEnable() => _timer = new RepaintTimer(() => Application.isPlaying || _diagnosis.IsDirty, Repaint);

        private void OnDisable()
        {
            _timer?.Dispose();
            _diagnosis.Dispose();
        }

        private void DrawFields(MocapSource[] sources)
        {
            serializedObject.Update();
            FieldDrawing.Draw(serializedObject, SourceFields.HiddenFor(sources).Contains, property =>
            {
                if (property.name is "_file" && GUILayout.Button(Browse))
                    ChooseFile(sources[0].Kind);
            });
            serializedObject.ApplyModifiedProperties();
        }

        private void ChooseFile(SourceKind kind)
        {
            string chosen = EditorUtility.OpenFilePanel("Motion", Application.streamingAssetsPath, kind == SourceKind.BvhFile ? "bvh" : "nmrec");
            if (chosen.Length > 0)
                serializedObject.FindProperty("_file").stringValue = ToFieldText(chosen, Application.streamingAssetsPath);
        }

        // Paths relative to StreamingAssets stay valid when the project moves, and in builds.
        internal static string ToFieldText(string path, string streamingAssets)
        {
            string full = Path.GetFullPath(path);
            string folder = Path.GetFullPath(streamingAssets) + Path.DirectorySeparatorChar;
            return full.StartsWith(folder, System.StringComparison.Ordinal) ? full.Substring(folder.Length).Replace('\\', '/') : path;
        }

        private void DrawReport(MocapSource source, SourceReport report)
        {
            ReportGui.Headline(report.Severity, report.Title);
            ReportGui.Message(report.Severity, report.Message);
            foreach (ReportRow row in report.Rows)
                ReportGui.Row(row);

            foreach (PerformerRow row in report.Performers)
                ReportGui.Row(new ReportRow($"{row.Name} ({row.AvatarIndex})", row.Summary, row.Severity));

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
