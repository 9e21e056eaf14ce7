using UnityEngine.StandIn;

namespace UnityEngine;

public static class GUI
{
    public static bool enabled { get; set; } = true;

    public static bool changed { get; set; }

    public static Color color { get; set; } = Color.white;

    public static Color contentColor { get; set; } = Color.white;

    public static void BeginClip(Rect position) => ImmediateGui.Clips.Push(position);

    public static void EndClip() => ImmediateGui.Clips.Pop();

    public static void Label(Rect position, string text) => ImmediateGui.Add("Label", text);

    public abstract class Scope : IDisposable
    {
        public void Dispose()
        {
            CloseScope();
            GC.SuppressFinalize(this);
        }

        protected abstract void CloseScope();
    }
}
