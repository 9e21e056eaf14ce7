#nullable enable
using System.Collections.Generic;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // The 59 bones as transforms, and the description that Unity needs for a Humanoid avatar.
    internal static class FigureSkeleton
    {
        private const float HalfTwist = 0.5f;
        private const float DefaultStretch = 0.05f;

        // Creates a child for every bone, in the T-pose, facing Z. The root must have no parent and an identity transform.
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

        // Unity also reads the live transforms, which must be as Create left them.
        public static HumanDescription Describe(Transform root, IReadOnlyList<Transform> bones, SkeletonVariant variant)
        {
            var skeleton = new List<UnityEngine.SkeletonBone>(bones.Count + 1) { Describe(root) };
            foreach (Transform bone in bones)
                skeleton.Add(Describe(bone));

            // With zeros, limbs would neither twist nor stretch. These are the importer's own values.
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

        // The bone for a human bone. Null for toes, eyes and jaw, which an actor's skeleton does not have.
        public static Bone? FindBone(HumanBodyBones human, SkeletonVariant variant)
        {
            // The lowest neck bone. Its rotation moves the whole neck, and the second bone follows.
            if (human == HumanBodyBones.Neck)
                return variant == SkeletonVariant.Spine3 ? Bone.Neck1 : Bone.Neck;

            return HumanoidMap.GetBone((HumanoidBone)human, variant, HumanoidBoneSet.All);
        }

        private static HumanBone[] MapHuman(SkeletonVariant variant)
        {
            // The names must be Unity's own: Unity ignores wrong names silently.
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
