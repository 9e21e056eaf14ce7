#nullable enable

using UnityEditor;

namespace NeuronMocap.Unity.EditorTools
{
    [CustomEditor(typeof(SkeletonView))]
    [CanEditMultipleObjects]
    internal sealed class SkeletonViewEditor : ProblemEditor
    {
        protected override (Severity Severity, string Title, string Problem) Describe() => ((SkeletonView)target).Performer is { } performer
            ? (Severity.Good, $"Shows {performer.Name} ({performer.AvatarIndex})", string.Empty)
            : (Severity.Waiting, "No performer to show", "It draws as soon as its performer has sent a frame. Set Driver, or Source and Performer Index, and switch Gizmos on in the scene view.");
    }
}
