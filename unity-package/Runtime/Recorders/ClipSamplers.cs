#nullable enable
using System.Collections.Generic;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // Chooses how a character is sampled for a clip.
    internal static class ClipSamplers
    {
        // owner: the root of a character without an Animator. hips: null for those of a Humanoid or of a driver, or else the root's first child.
        public static ClipSampler? Create(ClipKind kind, Animator? animator, Transform owner, Transform? hips, out string problem) => kind == ClipKind.Humanoid
            ? CreateHumanoid(animator, out problem)
            : CreateGeneric(animator, animator != null ? animator.transform : owner, hips, out problem);

        // For the rest of a take whose character is gone. Null if the take does not fit the character that took its place.
        public static ClipSampler? Replace(ClipSampler gone, ClipKind kind, Animator animator, Transform? hips)
        {
            ClipSampler? next = Create(kind, animator, animator.transform, hips, out _);
            if (next is null || next.TryContinue(gone))
                return next;

            next.Dispose();
            return null;
        }

        private static ClipSampler? CreateHumanoid(Animator? animator, out string problem)
        {
            problem = animator == null
                ? "This object and its children have no Animator: set Animator."
                : animator.avatar == null || !animator.isHuman
                ? $"The Animator of \"{animator.name}\" has no Humanoid avatar. In the model's import settings, tab Rig, set Animation Type to Humanoid, or set Kind to Generic."
                : "";
            return problem.Length == 0 ? new HumanoidSampler(animator!) : null;
        }

        private static ClipSampler? CreateGeneric(Animator? animator, Transform root, Transform? hips, out string problem)
        {
            if (hips == null && animator != null && animator.isHuman)
                hips = animator.GetBoneTransform(HumanBodyBones.Hips);
            if (hips == null)
                hips = FindDriven(root);
            if (hips == null && root.childCount > 0)
                hips = root.GetChild(0);

            problem = hips == null ? "There are no bones: set Hips."
                : !hips.IsChildOf(root) ? $"\"{hips.name}\" is not below \"{root.name}\": set Hips to a bone of the character."
                : "";
            if (problem.Length > 0)
                return null;

            var bones = new List<Transform>();
            hips!.GetComponentsInChildren(true, bones);
            return new GenericSampler(root, hips, bones);
        }

        // The hips that a driver on the root or above it moves. The figure of a driver above may also be another one, which holds the root.
        private static Transform? FindDriven(Transform root)
        {
            FigureDriver driver = root.GetComponentInParent<FigureDriver>();
            Transform? hips = driver != null ? driver.FindHips() : null;
            return hips != null && hips.IsChildOf(root) ? hips : null;
        }
    }
}
