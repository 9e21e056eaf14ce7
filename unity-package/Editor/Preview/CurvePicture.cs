#nullable enable

using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Two curves over the same time in a rectangle: what arrives in grey, and what is shown in orange.
    internal static class CurvePicture
    {
        public static readonly Color Received = new Color(0.55f, 0.57f, 0.60f);
        public static readonly Color Shown = new Color(1.00f, 0.55f, 0.15f);

        private const float Height = 90f;
        private const float Margin = 6f;
        private const float SmallestRange = 2f; // degrees

        private static readonly Color Background = new Color(0.16f, 0.17f, 0.19f);

        public static void Draw(IReadOnlyList<Vector2> received, IReadOnlyList<Vector2> shown)
        {
            Rect rect = GUILayoutUtility.GetRect(Height, Height, GUILayout.ExpandWidth(true));
            if (Event.current.type != EventType.Repaint || received.Count == 0)
                return;

            EditorGUI.DrawRect(rect, Background);
            Rect area = AreaOf(received, shown);
            var inside = new Rect(rect.x + Margin, rect.y + Margin, rect.width - (2 * Margin), rect.height - (2 * Margin));
            Draw(inside, area, received, Received, 1f);
            Draw(inside, area, shown, Shown, 2f);
        }

        private static void Draw(Rect rect, Rect area, IReadOnlyList<Vector2> points, Color color, float width)
        {
            var line = new Vector3[points.Count];
            for (int i = 0; i < line.Length; i++)
            {
                float right = (points[i].x - area.x) / area.width;
                float up = (points[i].y - area.y) / area.height;
                line[i] = new Vector3(rect.x + (right * rect.width), rect.y + ((1 - up) * rect.height));
            }

            Handles.color = color;
            Handles.DrawAAPolyLine(width, line);
        }

        // What the rectangle shows: seconds and degrees. A bone that stands still is a line in the middle.
        private static Rect AreaOf(params IReadOnlyList<Vector2>[] curves)
        {
            (float left, float right, float bottom, float top) = (float.MaxValue, float.MinValue, float.MaxValue, float.MinValue);
            foreach (IReadOnlyList<Vector2> curve in curves)
            {
                foreach (Vector2 point in curve)
                {
                    (left, right) = (Mathf.Min(left, point.x), Mathf.Max(right, point.x));
                    (bottom, top) = (Mathf.Min(bottom, point.y), Mathf.Max(top, point.y));
                }
            }

            float missing = Mathf.Max(0, SmallestRange - (top - bottom)) / 2;
            return new Rect(left, bottom - missing, Mathf.Max(right - left, 0.001f), top - bottom + (2 * missing));
        }
    }
}
