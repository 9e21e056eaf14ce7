#nullable enable
using System.Collections.Generic;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // The 59 bones as transforms, and what Unity has to know to see a human in them.
    internal static class FigureSkeleton
    {
        private const float HalfTwist = 0.5f;
        private const float DefaultStretch = 0.05f;

        // A child for every bone, standing in the T-pose and facing Z. The root has no parent and is not moved, turned or scaled.
        public static Transform[] Create(Transform root, SkeletonBody body)
        {
            var bones = new Transform[BoneHierarchy.BoneCount];
            foreach (Bone bone in BoneHierarchy.Bones)
            {
                Transform node = new GameObject(BoneHierarchy.GetName(bone, body.Variant)).transform;
                Bone? parent = BoneHierarchy.GetParent(bone, body.Variant);
                node.SetParent(parent is { } known ? bones[(int)known] : root, false);
                node.localPosition = body.GetOffset(bone).ToUnityPosition();
                bones[(int)bone] = node;
            }

            return bones;
        }

        // Unity reads the live transforms, too: they have to stand as Create left them.
        public static HumanDescription Describe(Transform root, IReadOnlyList<Transform> bones, SkeletonVariant variant)
        {
            var skeleton = new List<UnityEngine.SkeletonBone>(bones.Count + 1) { Describe(root) };
            foreach (Transform bone in bones)
                skeleton.Add(Describe(bone));

            // All zero would make limbs that neither twist nor stretch: these are the importer's own values.
            return new HumanDescription
            {
                human = MapHuman(variant),
                skeleton = skeleton.ToArray(),
                upperArmTwist = HalfTwist,
                lowerArmTwist = HalfTwist,
                upperLegTwist = HalfTwist,
                lowerLegTwist = HalfTwist,
                armStretch = DefaultStretch,
                legStretch = DefaultStretch,
                feetSpacing = 0,
                hasTranslationDoF = false,
            };
        }

        // The bone that carries a human bone; null for those that an actor does not have: toes, eyes, jaw.
        public static Bone? FindBone(HumanBodyBones human, SkeletonVariant variant)
        {
            // The lowest of the neck: its rotations are then the whole neck's, and the second bone follows.
            if (human == HumanBodyBones.Neck)
                return variant == SkeletonVariant.Spine3 ? Bone.Neck1 : Bone.Neck;

            return HumanoidMap.GetSource((HumanoidBone)human, variant, HumanoidBoneSet.All);
        }

        private static HumanBone[] MapHuman(SkeletonVariant variant)
        {
            // The names are Unity's own: it ignores wrong ones without a word.
            string[] names = HumanTrait.BoneName;
            var human = new List<HumanBone>(names.Length);
            for (int i = 0; i < names.Length; i++)
            {
                if (!(FindBone((HumanBodyBones)i, variant) is { } bone))
                    continue;

                human.Add(new HumanBone
                {
                    humanName = names[i],
                    boneName = BoneHierarchy.GetName(bone, variant),
                    limit = new HumanLimit { useDefaultValues = true },
                });
            }

            return human.ToArray();
        }

        private static UnityEngine.SkeletonBone Describe(Transform node) => new UnityEngine.SkeletonBone
        {
            name = node.name,
            position = node.localPosition,
            rotation = node.localRotation,
            scale = node.localScale,
        };
    }
}
