#nullable enable

using System.Collections.Generic;
using UnityEditor;

namespace NeuronMocap.Unity.EditorTools
{
    [CustomEditor(typeof(HumanoidDriver))]
    [CanEditMultipleObjects]
    internal sealed class HumanoidDriverEditor : FigureDriverEditor
    {
        protected override IReadOnlyList<RigProblem> Examine() => HumanoidCheck.Examine((HumanoidDriver)target);
    }
}
