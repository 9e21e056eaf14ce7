#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using NeuronMocap.Retargeting;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Checks a Humanoid figure as its driver will use it, before play mode, and offers fixes.
    internal static class HumanoidCheck
    {
        public const string BuiltLater = "The figure is built in play mode.";

        public static IReadOnlyList<RigProblem> Examine(HumanoidDriver driver)
        {
            Animator? animator = driver.Animator != null ? driver.Animator : driver.GetComponentInChildren<Animator>(true);
            if (animator == null)
                return new[] { WithoutAnimator(driver) };

            if (FindAvatarProblem(animator) is { } problem)
                return new[] { problem };

            var problems = new List<RigProblem>();
            AddSettings(animator, problems);
            if (animator.GetBoneTransform(HumanBodyBones.Hips) == null)
                problems.Add(WithoutTransforms(animator));
            else
                AddRig(animator, problems);

            return problems.OrderByDescending(found => found.Severity).ToArray();
        }

        private static RigProblem WithoutAnimator(HumanoidDriver driver)
        {
            if (driver.TryGetComponent(out FigureBuilder _))
                return new RigProblem(Severity.None, BuiltLater);

            Animator? above = driver.GetComponentInParent<Animator>();
            return above != null
                ? new RigProblem(
                    Severity.Error,
                    $"The Animator of this figure is on {above.name}, above this object, where the driver does not search.",
                    $"Assign {above.name}",
                    () => RigFixes.SetReference(driver, "_animator", above))
                : new RigProblem(
                    Severity.Error,
                    "No Animator found. Put this component on the figure, or assign the figure's Animator.",
                    "Add an Animator",
                    () => Undo.AddComponent<Animator>(driver.gameObject));
        }

        private static RigProblem? FindAvatarProblem(Animator animator)
        {
            ModelFile? model = ModelFile.Of(animator);
            if (animator.avatar == null)
            {
                return model?.FindAvatar() is { isHuman: true } avatar
                    ? new RigProblem(Severity.Error, "The Animator has no avatar; the model has one.", $"Assign {avatar.name}", () => RigFixes.SetAvatar(animator, avatar))
                    : new RigProblem(
                        Severity.Error,
                        "The Animator has no avatar." + (model is null ? " In the model's import settings, tab Rig, set Animation Type to Humanoid, and assign the avatar." : string.Empty),
                        model is null ? null : "Import the Model as Humanoid",
                        () => RigFixes.ImportAsHumanoid(animator, model!));
            }

            if (animator.avatar.isHuman && animator.avatar.isValid)
                return null;

            // isHuman is also false for an avatar that Unity failed to create. Its human description distinguishes the two cases.
            if (animator.avatar.isHuman || animator.avatar.humanDescription.human is { Length: > 0 })
            {
                return new RigProblem(
                    Severity.Error,
                    $"The avatar {animator.avatar.name} is not valid: {MissingOf(animator.avatar)}. In the model's import settings, tab Rig, open Configure.");
            }

            string fault = $"The avatar {animator.avatar.name} is not Humanoid.";
            return model is null
                ? new RigProblem(Severity.Error, $"{fault} In the model's import settings, tab Rig, set Animation Type to Humanoid, or use a Generic Rig Driver.")
                : new RigProblem(Severity.Error, fault, "Import the Model as Humanoid", () => RigFixes.ImportAsHumanoid(animator, model));
        }

        // Names of the required bones that the avatar does not map, as Unity spells them.
        private static string MissingOf(Avatar avatar)
        {
            var mapped = new HashSet<string>((avatar.humanDescription.human ?? Array.Empty<HumanBone>()).Select(bone => bone.humanName), StringComparer.Ordinal);
            string[] missing = Enumerable.Range(0, HumanoidBones.Count).Select(index => (HumanoidBone)index)
                .Where(bone => HumanoidBones.IsRequired(bone) && !mapped.Contains(HumanoidBones.GetName(bone)))
                .Select(bone => HumanoidBones.GetName(bone))
                .ToArray();
            return missing.Length > 0 ? $"it does not map {string.Join(", ", missing)}" : "Unity did not accept its bones";
        }

        private static void AddSettings(Animator animator, List<RigProblem> problems)
        {
            if (animator.applyRootMotion && animator.runtimeAnimatorController != null)
            {
                problems.Add(new RigProblem(
                    Severity.Warning,
                    "Apply Root Motion is on: animations move the object away while the driver moves the figure in it.",
                    "Switch Root Motion Off",
                    () => RigFixes.Change(animator, "Switch Root Motion Off", () => animator.applyRootMotion = false)));
            }
        }

        private static RigProblem WithoutTransforms(Animator animator)
        {
            // An Animator finds its bones when its object first becomes active.
            if (!animator.gameObject.activeInHierarchy)
                return new RigProblem(Severity.None, $"{animator.name} is not active: its bones cannot be checked.");

            const string Text = "The figure's bones are not transforms of the scene: Optimize Game Objects is on in the model's import settings.";
            return ModelFile.Of(animator) is { } model
                ? new RigProblem(Severity.Error, Text, "Switch Optimizing Off", model.KeepTransforms)
                : new RigProblem(Severity.Error, Text);
        }

        private static void AddRig(Animator animator, List<RigProblem> problems)
        {
            Transform root = animator.transform;
            var bones = new Transform?[HumanoidBones.Count];
            for (int bone = 0; bone < bones.Length; bone++)
                bones[bone] = animator.GetBoneTransform((HumanBodyBones)bone);

            RestPose rest = RestPose.OfAvatar(root, animator.avatar!);
            RigCapture capture = RigCapture.Take(root, bones, rest);
            int[] nodeByBone = Array.ConvertAll(bones, capture.IndexOf);
            IReadOnlyList<RigIssue> issues = RigValidator.Validate(capture.Nodes, nodeByBone);
            Action? fix = FindFix(animator, capture, nodeByBone, rest);
            problems.AddRange(RigIssues.ToProblems(issues, fix));
        }

        // Where a rest pose is corrected depends on its origin. One from the import settings is changed there. One from the current transforms is
        // changed in the scene. A bind pose can only be changed in the program that the model comes from.
        private static Action? FindFix(Animator animator, RigCapture capture, int[] nodeByBone, RestPose rest)
        {
            if (rest.Note is RestPose.FromPresent)
                return () => RigFixes.Pose(capture.Transforms, TPose.Enforce(TargetRig.CreateHumanoid(capture.Nodes, nodeByBone)));
            if (rest.Note.Length == 0 && ModelFile.Of(animator) is { } model)
                return () => model.SetRestPose(animator.avatar!, TPose.Enforce(TargetRig.CreateHumanoid(capture.Nodes, nodeByBone)).Nodes);

            return null;
        }
    }
}
