#nullable enable

using System.Linq;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    [CustomEditor(typeof(MotionRecorder))]
    [CanEditMultipleObjects]
    internal sealed class MotionRecorderEditor : ProblemEditor
    {
        public const string Start = "Start Recording";
        public const string Stop = "Stop Recording";
        public const string Show = "Show the Files";

        private RecorderState _state;
        private bool _hasFiles;

        protected override (Severity Severity, string Title, string Problem) Describe()
        {
            var recorder = (MotionRecorder)target;
            _state = recorder.State;
            _hasFiles = recorder.Files.Count > 0;
            string size = $"{PerformerRow.Number(recorder.Elapsed, "0.0")} s, {PerformerRow.Number(recorder.Frames, "#,0")} frames, "
                + $"{PerformerRow.Number(recorder.Bytes / 1e6, "0.0")} MB";
            string title = _state switch
            {
                RecorderState.Waiting => "Waiting for the source to open",
                RecorderState.Recording => $"Recording: {size}",
                RecorderState.Finishing => $"Completing the files: {size}",
                _ => _hasFiles ? $"Recorded: {size}" : "Ready",
            };
            Severity severity = recorder.Problem.Length > 0 ? Severity.Error
                : _state == RecorderState.Recording ? Severity.Good
                : _state == RecorderState.Idle ? Severity.None
                : Severity.Waiting;
            return (severity, title, recorder.Problem);
        }

        protected override void DrawButtons()
        {
            var recorder = (MotionRecorder)target;
            using (new EditorGUILayout.HorizontalScope())
            {
                using (new EditorGUI.DisabledScope(_state == RecorderState.Finishing))
                {
                    bool isOn = _state == RecorderState.Recording || _state == RecorderState.Waiting;
                    if (GUILayout.Button(isOn ? Stop : Start))
                    {
                        if (isOn)
                            recorder.StopRecording();
                        else
                            recorder.StartRecording();
                    }
                }

                using (new EditorGUI.DisabledScope(!_hasFiles))
                {
                    if (GUILayout.Button(Show))
                        EditorUtility.RevealInFinder(recorder.Files.First());
                }
            }
        }
    }
}
