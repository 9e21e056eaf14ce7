#nullable enable

using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // An orthographic view of a figure. Maps world points in metres to a rectangle of the window, in pixels with Y down. A figure that faces +Z is
    // seen from the front at a yaw of 0, and from its left side at 90.
    internal sealed class PreviewView
    {
        private const float DegreesPerPixel = 0.5f;
        private const float HighestPitch = 89f;
        private const float FigureHeight = 2.2f;

        public float Yaw { get; private set; }

        public float Pitch { get; private set; } = 8f;

        // The height of the rectangle, in metres.
        public float Height { get; private set; } = FigureHeight;

        // The world point in the middle of the rectangle.
        public Vector3 Center { get; set; } = new Vector3(0f, FigureHeight / 2f, 0f);

        public void LookFromFront() => (Yaw, Pitch) = (0f, 0f);

        public void LookFromSide() => (Yaw, Pitch) = (90f, 0f);

        public void Orbit(Vector2 pixels)
        {
            Yaw = Mathf.Repeat(Yaw + (pixels.x * DegreesPerPixel) + 180f, 360f) - 180f;
            Pitch = Mathf.Clamp(Pitch + (pixels.y * DegreesPerPixel), -HighestPitch, HighestPitch);
        }

        public void Zoom(float factor) => Height = Mathf.Clamp(Height * factor, 0.3f, 20f);

        public Vector2 Project(Vector3 point, Rect rect)
        {
            float yaw = Yaw * Mathf.Deg2Rad;
            float pitch = Pitch * Mathf.Deg2Rad;
            Vector3 offset = point - Center;

            // Seen from the front, the figure's right, +X, is on the left of the picture.
            float right = (-offset.x * Mathf.Cos(yaw)) - (offset.z * Mathf.Sin(yaw));
            float toViewer = (-offset.x * Mathf.Sin(yaw)) + (offset.z * Mathf.Cos(yaw));
            float up = (offset.y * Mathf.Cos(pitch)) - (toViewer * Mathf.Sin(pitch));
            float scale = rect.height / Height;
            return new Vector2(rect.center.x + (right * scale), rect.center.y - (up * scale));
        }
    }
}
