#nullable enable

using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    [CustomEditor(typeof(ClipRecorder))]
    [CanEditMultipleObjects]
    internal sealed class ClipRecorderEditor : TakeRecorderEditor
    {
        public const string ShowClip = "Show the Clip";

        public ClipRecorderEditor()
            : base(ShowClip)
        {
        }

        protected override bool CanShow => ((ClipRecorder)target).SavedPath.Length > 0;

        protected override (Severity Severity, string Title) DescribeTake()
        {
            var recorder = (ClipRecorder)target;
            string size = $"{PerformerRow.Number(recorder.Elapsed, "0.0")} s, {PerformerRow.Number(recorder.Take?.FrameCount ?? 0, "#,0")} frames";
            return recorder.IsRecording ? (Severity.Good, $"Recording: {size}")
                : CanShow ? (Severity.None, $"Saved as {recorder.SavedPath}: {size}")
                : (Severity.None, "Ready");
        }

        protected override void Show() => EditorGUIUtility.PingObject(AssetDatabase.LoadAssetAtPath<AnimationClip>(((ClipRecorder)target).SavedPath));

        protected override bool IsHidden(string field) => field is "_hips" && serializedObject.Is("_kind", (int)ClipKind.Humanoid);
    }
}
