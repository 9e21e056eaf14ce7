#nullable enable

using System.Linq;
using UnityEditor;

namespace NeuronMocap.Unity.EditorTools
{
    [CustomEditor(typeof(MotionRecorder))]
    [CanEditMultipleObjects]
    internal sealed class MotionRecorderEditor : TakeRecorderEditor
    {
        public const string ShowFiles = "Show the Files";

        public MotionRecorderEditor()
            : base(ShowFiles)
        {
        }

        protected override bool CanStart => ((MotionRecorder)target).State != RecorderState.Finishing;

        protected override bool CanShow => ((MotionRecorder)target).Files.Count > 0;

        protected override (Severity Severity, string Title) DescribeTake()
        {
            var recorder = (MotionRecorder)target;
            string size = $"{PerformerRow.Number(recorder.Elapsed, "0.0")} s, {PerformerRow.Number(recorder.Frames, "#,0")} frames, "
                + $"{PerformerRow.Number(recorder.Bytes / 1e6, "0.0")} MB";
            return recorder.State switch
            {
                RecorderState.Waiting => (Severity.Waiting, "Waiting for the source to open"),
                RecorderState.Recording => (Severity.Good, $"Recording: {size}"),
                RecorderState.Finishing => (Severity.Waiting, $"Completing the files: {size}"),
                _ => (Severity.None, CanShow ? $"Recorded: {size}" : "Ready"),
            };
        }

        protected override void Show() => EditorUtility.RevealInFinder(((MotionRecorder)target).Files.First());

        protected override bool IsHidden(string field) => field is "_performerIndex" && serializedObject.Is("_allPerformers", true);
    }
}
