#nullable enable

using System;
using NeuronMocap.Retargeting;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace NeuronMocap.Unity.EditorTools
{
    // The actions of the rig check's buttons. All of them can be undone, except imports of a model, as everywhere in Unity.
    internal static class RigFixes
    {
        public static void SetReference(Object target, string field, Object value)
        {
            var serialized = new SerializedObject(target);
            serialized.FindProperty(field).objectReferenceValue = value;
            serialized.ApplyModifiedProperties();
        }

        public static void SetText(Object target, string field, string value)
        {
            var serialized = new SerializedObject(target);
            serialized.FindProperty(field).stringValue = value;
            serialized.ApplyModifiedProperties();
        }

        public static void SetChoice(Object target, string field, int index)
        {
            var serialized = new SerializedObject(target);
            serialized.FindProperty(field).enumValueIndex = index;
            serialized.ApplyModifiedProperties();
        }

        public static void Change(Object target, string name, Action change)
        {
            Undo.RecordObject(target, name);
            change();
            PrefabUtility.RecordPrefabInstancePropertyModifications(target);
        }

        public static void SetAvatar(Animator animator, Avatar avatar) => Change(animator, "Assign Avatar", () => animator.avatar = avatar);

        public static void ImportAsHumanoid(Animator animator, ModelFile model)
        {
            model.ImportAsHumanoid();
            if (animator.avatar == null && model.FindAvatar() is { } avatar)
                SetAvatar(animator, avatar);
        }

        // transforms: the transforms of the rig's nodes.
        public static void Pose(Transform[] transforms, TargetRig rig)
        {
            Undo.RecordObjects(transforms, "Put Into T-Pose");
            for (int i = 0; i < transforms.Length; i++)
            {
                transforms[i].localPosition = rig.Nodes[i].Position.ToUnity();
                transforms[i].localRotation = rig.Nodes[i].Rotation.ToUnity();
                PrefabUtility.RecordPrefabInstancePropertyModifications(transforms[i]);
            }
        }
    }
}
