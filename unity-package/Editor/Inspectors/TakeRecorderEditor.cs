#nullable enable

using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // The common part of both recorders' inspectors.
    internal abstract class TakeRecorderEditor : ProblemEditor
    {
        public const string Start = "Start Recording";
        public const string Stop = "Stop Recording";

        private readonly string _showLabel;
        private bool _isRecording;
        private bool _canStart;
        private bool _canShow;

        // showLabel: the button that shows what was recorded.
        protected TakeRecorderEditor(string showLabel) => _showLabel = showLabel;

        protected sealed override (Severity Severity, string Title, string Problem) Describe()
        {
            var recorder = (TakeRecorder)target;
            (Severity severity, string title) = DescribeTake();
            _isRecording = recorder.IsRecording;
            _canStart = CanStart;
            _canShow = CanShow;
            return (recorder.Problem.Length > 0 ? Severity.Error : severity, title, recorder.Problem);
        }

        protected abstract (Severity Severity, string Title) DescribeTake();

        protected virtual bool CanStart => true;

        protected abstract bool CanShow { get; }

        protected abstract void Show();

        protected virtual bool IsHidden(string field) => false;

        // The fields of the recorder itself come first, because they say what is recorded.
        protected sealed override void DrawFields()
        {
            serializedObject.Update();
            FieldDrawing.Draw(serializedObject, field => IsCommon(field) || IsHidden(field));
            FieldDrawing.Draw(serializedObject, field => !IsCommon(field));
            serializedObject.ApplyModifiedProperties();
        }

        protected sealed override void DrawButtons()
        {
            var recorder = (TakeRecorder)target;
            using (new EditorGUILayout.HorizontalScope())
            {
                using (new EditorGUI.DisabledScope(!_isRecording && !_canStart))
                {
                    if (GUILayout.Button(_isRecording ? Stop : Start))
                    {
                        if (_isRecording)
                            recorder.StopRecording();
                        else
                            recorder.StartRecording();
                    }
                }

                using (new EditorGUI.DisabledScope(!_canShow))
                {
                    if (GUILayout.Button(_showLabel))
                        Show();
                }
            }
        }

        private static bool IsCommon(string field) => field is "_takeName" or "_slate" or "_fileName" or "_recordOnPlay";
    }
}
