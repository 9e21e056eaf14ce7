#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Checks a rig without an avatar as its driver will use it: the transforms that it finds, and their rest pose.
    internal static class GenericCheck
    {
        public const string UseTPose = "Use the T-Pose";

        public static IReadOnlyList<RigProblem> Examine(GenericRigDriver driver) => Examine(driver, out _);

        // rest: the rig in its rest pose, or null if it cannot be driven.
        public static IReadOnlyList<RigProblem> Examine(GenericRigDriver driver, out TargetRig? rest)
        {
            rest = null;
            Transform root = driver.RigRoot;
            Transform?[] bones = driver.FindBones(root);
            if (bones[0] == null)
                return new[] { WithoutHips(driver, root) };

            var problems = new List<RigProblem>();
            AddMissing(bones, problems);
            try
            {
                TargetRig rig = driver.CaptureRest(root, bones, out RigCapture capture, out string note);
                rest = rig;

                // A pose in the scene is corrected there. A bind pose belongs to the model, so the driver corrects it.
                problems.AddRange(driver.RestPoseChoice == RestPoseChoice.AsItStands || note is RestPose.FromPresent
                    ? RigIssues.ToProblems(RigValidator.Validate(rig), () => RigFixes.Pose(capture.Transforms, TPose.Enforce(rig)))
                    : RigIssues.ToProblems(RigValidator.Validate(rig), () => RigFixes.SetChoice(driver, "_restPoseChoice", (int)RestPoseChoice.TPose), UseTPose));
            }
            catch (ArgumentException exception)
            {
                problems.Add(new RigProblem(Severity.Error, $"The rig cannot be driven: {exception.Message}"));
            }

            return problems.OrderByDescending(problem => problem.Severity).ToArray();
        }

        private static RigProblem WithoutHips(GenericRigDriver driver, Transform root)
        {
            string text = $"No transform below {root.name} is called {driver.Prefix}Hips.";
            RigBinding guess = GenericRigDriver.BindNames(root, prefix: null, out _);
            return driver.Prefix.Length > 0 && guess.GetNode(Bone.Hips) >= 0
                ? new RigProblem(
                    Severity.Error,
                    $"{text} With another prefix {guess.FoundCount} of {BoneHierarchy.BoneCount} bones are found.",
                    guess.Prefix.Length > 0 ? $"Use Prefix {guess.Prefix}" : "Clear Prefix",
                    () => RigFixes.SetText(driver, "_prefix", guess.Prefix))
                : new RigProblem(Severity.Error, $"{text} Change Prefix, or list the transforms in Bindings.");
        }

        private static void AddMissing(Transform?[] bones, List<RigProblem> problems)
        {
            string[] missing = BoneHierarchy.Bones.ToArray().Where(bone => bones[(int)bone] == null).Select(bone => BoneHierarchy.GetName(bone)).ToArray();
            if (missing.Length > 0)
                problems.Add(new RigProblem(Severity.None, $"{missing.Length} bones have no transform and have no effect: {string.Join(", ", missing)}."));
        }
    }
}
