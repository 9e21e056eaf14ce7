#nullable enable

using System;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Adds colliders to a figure and lets physics move it, as a single undo step.
    internal static class ColliderCommand
    {
        private const string Name = "Add Colliders";

        public static void Run(FigureDriver driver)
        {
            Undo.SetCurrentGroupName(Name);
            int group = Undo.GetCurrentGroup();
            try
            {
                FigureColliders.Add(driver, Undo.AddComponent<Rigidbody>, holder => Undo.RegisterCreatedObjectUndo(holder, Name));
            }
            catch (InvalidOperationException exception)
            {
                Debug.LogError(exception.Message, driver);
                return;
            }

            RigFixes.Change(driver, Name, () => driver.DriveTime = DriveTime.Physics);
            Undo.CollapseUndoOperations(group);
        }
    }
}
