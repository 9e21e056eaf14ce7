#nullable enable

using System.Collections.Generic;
using NeuronMocap.Retargeting;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    [CustomEditor(typeof(GenericRigDriver))]
    [CanEditMultipleObjects]
    internal sealed class GenericRigDriverEditor : FigureDriverEditor
    {
        public const string PreviewLabel = "Rest Pose";

        private const float PreviewHeight = 180f;

        private readonly SkeletonPreview _preview = new SkeletonPreview();
        private bool _showsPreview = true;
        private TargetRig? _rest;

        protected override IReadOnlyList<RigProblem> Examine() => GenericCheck.Examine((GenericRigDriver)target, out _rest);

        protected override void DrawRestPose()
        {
            _showsPreview = EditorGUILayout.Foldout(_showsPreview, PreviewLabel, toggleOnLabelClick: true);
            if (_showsPreview)
                _preview.Draw(GUILayoutUtility.GetRect(PreviewHeight, PreviewHeight, GUILayout.ExpandWidth(true)), _rest);
        }
    }
}
