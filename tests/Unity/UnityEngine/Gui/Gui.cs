#pragma warning disable MA0048, CA1711
namespace UnityEngine
{
    /// <summary>What OnGUI shows in a frame, for tests to read; a test clicks a button by its text.</summary>
    public static class GUI
    {
        internal static List<string> Shown { get; } = [];

        internal static string? ClickedButton { get; set; }

        public static bool enabled { get; set; } = true;

        public static void Label(Rect position, string text) => Shown.Add(text);

        public static bool Button(Rect position, string text) => Press(text);

        internal static bool Press(string text)
        {
            Shown.Add(text);
            if (ClickedButton != text || !enabled)
                return false;

            ClickedButton = null;
            return true;
        }
    }

    public class GUILayoutOption
    {
    }

    public static class GUILayout
    {
        public static void BeginArea(Rect screenRect)
        {
        }

        public static void EndArea()
        {
        }

        public static void BeginHorizontal(params GUILayoutOption[] options)
        {
        }

        public static void EndHorizontal()
        {
        }

        public static void Label(string text, params GUILayoutOption[] options) => GUI.Shown.Add(text);

        public static bool Button(string text, params GUILayoutOption[] options) => GUI.Press(text);
    }

    public sealed class Event
    {
        public static Event current { get; internal set; } = new();

        public EventType type { get; internal set; } = EventType.Repaint;

        public Vector2 delta { get; internal set; }
    }

    public enum EventType
    {
        MouseDown = 0,
        MouseUp = 1,
        MouseMove = 2,
        MouseDrag = 3,
        Repaint = 7,
        Layout = 8,
    }
}
