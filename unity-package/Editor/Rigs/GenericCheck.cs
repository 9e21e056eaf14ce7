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
        public static IReadOnlyList<RigProblem> Examine(GenericRigDriver driver)
        {
            Transform root = driver.Root != null ? driver.Root : driver.transform;
            Transform?[] bones = driver.FindBones(root);
            if (bones[0] == null)
                return new[] { WithoutHips(driver, root) };

            var problems = new List<RigProblem>();
            AddMissing(bones, problems);
            RestPose rest = RestPose.OfSkins(root);
            RigCapture capture = RigCapture.Take(root, bones, rest);
            try
            {
                TargetRig rig = TargetRig.CreateGeneric(capture.Nodes, Array.ConvertAll(bones, capture.IndexOf));
                Action? fix = rest.Note is RestPose.FromPresent ? () => RigFixes.Pose(capture.Transforms, TPose.Enforce(rig)) : (Action?)null;
                problems.AddRange(RigIssues.ToProblems(RigValidator.Validate(rig), fix));
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
