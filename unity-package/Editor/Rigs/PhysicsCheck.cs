#nullable enable

using System.Collections.Generic;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Whether physics can move a figure as its driver expects.
    internal static class PhysicsCheck
    {
        public const string AddColliders = "Add Colliders";
        public const string MakeKinematic = "Make Kinematic";
        public const string UsePhysics = "Move in Physics Steps";

        public static IEnumerable<RigProblem> Examine(FigureDriver driver)
        {
            bool isPhysics = driver.DriveTime == DriveTime.Physics;
            if (!isPhysics && driver.GetComponentInChildren<Rigidbody>(true) == null)
                yield break;
            if (!(driver.FindRig(out _) is { } rig))
                yield break;

            int bodies = 0;
            foreach (Transform node in rig.Nodes)
            {
                if (node == null || !node.TryGetComponent(out Rigidbody body))
                    continue;

                bodies++;
                if (!body.isKinematic)
                {
                    yield return new RigProblem(
                        Severity.Error,
                        $"{node.name} has a Rigidbody that is not kinematic. Physics and the driver would both move it.",
                        MakeKinematic,
                        () => RigFixes.Change(body, MakeKinematic, () => body.isKinematic = true));
                }
            }

            if (isPhysics && bodies == 0)
            {
                yield return new RigProblem(
                    Severity.Warning,
                    "No bone has a Rigidbody, so the figure does not push other objects.",
                    AddColliders,
                    () => ColliderCommand.Run(driver));
            }
            else if (!isPhysics && bodies > 0)
            {
                yield return new RigProblem(
                    Severity.Warning,
                    "Bones have a Rigidbody, but Drive Time is not Physics. Objects in the way are not pushed with the right speed.",
                    UsePhysics,
                    () => RigFixes.Change(driver, UsePhysics, () => driver.DriveTime = DriveTime.Physics));
            }
        }
    }
}
