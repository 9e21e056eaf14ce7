#nullable enable

using System.Collections.Generic;
using UnityEditor;

namespace NeuronMocap.Unity.EditorTools
{
    [CustomEditor(typeof(GenericRigDriver))]
    [CanEditMultipleObjects]
    internal sealed class GenericRigDriverEditor : FigureDriverEditor
    {
        protected override IReadOnlyList<RigProblem> Examine() => GenericCheck.Examine((GenericRigDriver)target);
    }
}
