#nullable enable

using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    [CustomEditor(typeof(HandProp))]
    [CanEditMultipleObjects]
    internal sealed class HandPropEditor : Editor
    {
        private const string Message =
            "The Rigidbody is not kinematic. In play mode, it is kinematic while the prop is held, and falls when this component is disabled. If the prop "
            + "is never let go, make it kinematic.";

        public override void OnInspectorGUI()
        {
            DrawDefaultInspector();
            if (targets.Length > 1 || !((HandProp)target).TryGetComponent(out Rigidbody body) || body.isKinematic)
                return;

            EditorGUILayout.HelpBox(Message, MessageType.Warning);
            if (GUILayout.Button(PhysicsCheck.MakeKinematic))
                RigFixes.Change(body, PhysicsCheck.MakeKinematic, () => body.isKinematic = true);
        }
    }
}
