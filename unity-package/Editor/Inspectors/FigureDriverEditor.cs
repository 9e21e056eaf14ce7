#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // The common part of both drivers' inspectors: the relevant fields, whether the figure moves and why not, and the check of its rig.
    internal abstract class FigureDriverEditor : Editor
    {
        public const string CheckAgain = "Check the Rig Again";

        private RepaintTimer? _timer;
        private DelayPicture? _picture;
        private DriverReport? _report;
        private IReadOnlyList<ReportRow> _smoothing = Array.Empty<ReportRow>();
        private IReadOnlyList<RigProblem>? _problems;
        private bool _isSmoothed;

        internal IReadOnlyList<RigProblem> Problems => _problems ??= ExamineAll();

        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            int? preset = null;
            SerializedProperty weights = serializedObject.FindProperty("_boneWeights");
            bool hadNone = weights.arraySize == 0 && !weights.hasMultipleDifferentValues;
            FieldDrawing.Draw(serializedObject, IsHidden, property =>
            {
                if (property.name is "_smoothing")
                    preset = SmoothingPresets.Draw(targets);
            });
            if (hadNone)
                GiveFullWeight(weights);
            if (serializedObject.ApplyModifiedProperties())
                _problems = null;
            if (preset is { } chosen)
                SmoothingPresets.Apply(chosen, targets);

            EditorGUILayout.Space();
            if (targets.Length > 1)
                return;

            // A figure that moves does not show its rest pose, which is already captured.
            var driver = (FigureDriver)target;
            bool isMoved = Application.isPlaying || driver.IsPreviewed || driver.IsPosed;
            if (_report is null || Event.current.type == EventType.Layout)
            {
                _report = DriverReport.Of(driver, Application.isPlaying);
                _smoothing = SmoothingReport.Of(driver);
                _isSmoothed = driver.Smoothing;
                if (!isMoved)
                    _problems ??= ExamineAll();
            }

            ReportGui.Headline(_report.Severity, _report.Title);
            ReportGui.Message(_report.Severity, _report.Message);
            foreach (ReportRow row in _smoothing)
                ReportGui.Row(row);

            if (_isSmoothed)
                _picture!.DrawSmoothing(driver);
            if (isMoved)
                return;

            DrawRig(Problems);
            DrawRestPose();
        }

        protected abstract IReadOnlyList<RigProblem> Examine();

        // What is below the check, outside play mode.
        protected virtual void DrawRestPose()
        {
        }

        private RigProblem[] ExamineAll() => Examine().Concat(PhysicsCheck.Examine((FigureDriver)target)).ToArray();

        private void OnEnable()
        {
            _picture = new DelayPicture(() => target is FigureDriver driver && driver != null ? driver.Performer : null, isOpen: true);
            _timer = new RepaintTimer(() => Application.isPlaying || LivePreview.IsOn, Repaint);
            EditorApplication.hierarchyChanged += Forget;
            Undo.undoRedoPerformed += Forget;
        }

        private void OnDisable()
        {
            _picture?.Dispose();
            _timer?.Dispose();
            EditorApplication.hierarchyChanged -= Forget;
            Undo.undoRedoPerformed -= Forget;
        }

        private void Forget()
        {
            _problems = null;
            Repaint();
        }

        private bool IsHidden(string name) => name switch
        {
            "_performerIndex" => serializedObject.Is("_performerChoice", (int)PerformerChoice.ByName),
            "_performerName" => serializedObject.Is("_performerChoice", (int)PerformerChoice.ByIndex),
            "_scale" => serializedObject.Is("_automaticScale", true),
            "_groundHeight" or "_footBlendTime" => serializedObject.Is("_footPlanting", false),
            "_partSmoothing" => serializedObject.Is("_smoothing", false),
            "_idleBlendTime" => serializedObject.Is("_whenIdle", (int)IdleBehaviour.Hold),
            _ => false,
        };

        // Unity fills the first element of a list with zeros, which would stop the hips.
        private static void GiveFullWeight(SerializedProperty weights)
        {
            for (int i = 0; i < weights.arraySize; i++)
                weights.GetArrayElementAtIndex(i).FindPropertyRelative(nameof(HumanoidBoneWeight.Weight)).floatValue = 1;
        }

        private void DrawRig(IReadOnlyList<RigProblem> problems)
        {
            Severity worst = problems.Select(problem => problem.Severity).DefaultIfEmpty(Severity.Good).Max();
            ReportGui.Headline(worst == Severity.None ? Severity.Good : worst, worst <= Severity.Good ? "The rig is right" : "The rig");
            Action? chosen = null;
            foreach (RigProblem problem in problems)
            {
                ReportGui.Message(problem.Severity, problem.Text);
                if (problem.FixLabel is { } label && GUILayout.Button(label))
                    chosen = problem.Fix;
            }

            bool again = GUILayout.Button(CheckAgain);
            chosen?.Invoke();
            if (chosen is not null || again)
                _problems = null;
        }
    }
}
