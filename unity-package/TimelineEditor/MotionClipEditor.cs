#nullable enable

using System.Globalization;
using NeuronMocap.Unity.EditorTools;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.Timeline.EditorTools
{
    // The fields of a clip, and below them what its file holds, or why it cannot be used.
    [CustomEditor(typeof(MotionClip))]
    [CanEditMultipleObjects]
    internal sealed class MotionClipEditor : Editor
    {
        public const string Browse = "Browse...";
        public const string ReadAgain = "Read the File Again";

        private (MotionTake? Take, string Problem) _state = (null, string.Empty);

        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            FieldDrawing.Draw(serializedObject, _ => false, property =>
            {
                if (property.name is "_file" && GUILayout.Button(Browse))
                    MotionFilePanel.Choose(property, "bvh,nmrec");
            });
            serializedObject.ApplyModifiedProperties();
            if (targets.Length > 1)
                return;

            var clip = (MotionClip)target;
            if (Event.current.type == EventType.Layout)
                _state = (clip.Load(), clip.Problem);

            EditorGUILayout.Space();
            if (_state.Take is { } take)
                ReportGui.Headline(Severity.Good, Describe(clip.FileName, take));

            ReportGui.Message(Severity.Error, _state.Problem);
            if (GUILayout.Button(ReadAgain))
                clip.Reload();
        }

        private static string Describe(string file, MotionTake take)
        {
            string who = take.PerformerName.Length > 0 ? $"{take.PerformerName} in {file}" : file;
            return string.Format(CultureInfo.InvariantCulture, "{0}: {1:0.00} s, {2:#,0} frames, {3:0.##} /s", who, take.Duration, take.FrameCount, take.FrameRate);
        }
    }
}
