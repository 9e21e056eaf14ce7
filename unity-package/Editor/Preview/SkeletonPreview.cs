#nullable enable

using System;
using System.Collections.Generic;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Draws the bones of a performer, or of a rig at rest, in a rectangle of a window. Dragging turns the view, the wheel zooms.
    internal sealed class SkeletonPreview
    {
        private const float BoneWidth = 3f;
        private const int GridCells = 4;

        private static readonly Color Background = new Color(0.16f, 0.17f, 0.19f);
        private static readonly Color Grid = new Color(0.30f, 0.32f, 0.36f);
        private static readonly Color Left = new Color(0.35f, 0.65f, 1.00f);
        private static readonly Color Right = new Color(1.00f, 0.55f, 0.35f);
        private static readonly Color Middle = new Color(0.90f, 0.90f, 0.90f);

        public PreviewView View { get; } = new PreviewView();

        public void Draw(Rect rect, Performer? performer) =>
            Draw(rect, performer is { HasPose: true } ? performer.GetPosition(Bone.Hips) : (Vector3?)null, inside => LinesOf(performer!, inside));

        // Draws a rig at rest, as large as a person.
        public void Draw(Rect rect, TargetRig? rig) => Draw(rect, rig is null ? (Vector3?)null : Vector3.zero, inside => RestLines.Of(rig!, View, inside));

        // A line from each joint's parent to the joint, and a line to the end of each bone without children.
        internal IEnumerable<(Vector2 From, Vector2 To, Bone Bone)> LinesOf(Performer performer, Rect rect)
        {
            for (int i = 0; i < BoneHierarchy.BoneCount; i++)
            {
                var bone = (Bone)i;
                if (BoneHierarchy.GetParent(bone, performer.Variant) is { } parent)
                    yield return (View.Project(performer.GetPosition(parent), rect), View.Project(performer.GetPosition(bone), rect), bone);
            }

            foreach (Bone bone in JointPositions.EndSiteBones.ToArray())
                yield return (View.Project(performer.GetPosition(bone), rect), View.Project(performer.GetEndPosition(bone), rect), bone);
        }

        private void Draw(Rect rect, Vector3? hips, Func<Rect, IEnumerable<(Vector2 From, Vector2 To, Bone Bone)>> linesOf)
        {
            Event current = Event.current;
            if (rect.Contains(current.mousePosition))
                Respond(current);
            if (current.type != EventType.Repaint)
                return;

            EditorGUI.DrawRect(rect, Background);
            if (hips is null)
                return;

            View.Center = CenterOf(hips.Value);
            GUI.BeginClip(rect);
            var inside = new Rect(0f, 0f, rect.width, rect.height);
            DrawGrid(inside);
            foreach ((Vector2 from, Vector2 to, Bone bone) in linesOf(inside))
            {
                Handles.color = ColorOf(bone);
                Handles.DrawAAPolyLine(BoneWidth, from, to);
            }

            GUI.EndClip();
        }

        private static Vector3 CenterOf(Vector3 hips) => new Vector3(hips.x, 0.95f, hips.z);

        private static Color ColorOf(Bone bone)
        {
            string name = BoneHierarchy.GetName(bone);
            return name.StartsWith("Left", StringComparison.Ordinal) ? Left
                : name.StartsWith("Right", StringComparison.Ordinal) ? Right
                : Middle;
        }

        private void Respond(Event current)
        {
            if (current.type == EventType.MouseDrag && current.button == 0)
                View.Orbit(current.delta);
            else if (current.type == EventType.ScrollWheel)
                View.Zoom(current.delta.y > 0f ? 1.1f : 1f / 1.1f);
            else
                return;

            current.Use();
        }

        // The ground under the performer, in squares of half a metre. The squares do not move with the performer.
        private void DrawGrid(Rect rect)
        {
            const float Cell = 0.5f;
            float x = Mathf.Round(View.Center.x / Cell) * Cell;
            float z = Mathf.Round(View.Center.z / Cell) * Cell;
            float half = GridCells * Cell;
            Handles.color = Grid;
            for (int i = -GridCells; i <= GridCells; i++)
            {
                float step = i * Cell;
                DrawLine(rect, new Vector3(x + step, 0f, z - half), new Vector3(x + step, 0f, z + half));
                DrawLine(rect, new Vector3(x - half, 0f, z + step), new Vector3(x + half, 0f, z + step));
            }
        }

        private void DrawLine(Rect rect, Vector3 from, Vector3 to) => Handles.DrawLine(View.Project(from, rect), View.Project(to, rect));
    }
}
