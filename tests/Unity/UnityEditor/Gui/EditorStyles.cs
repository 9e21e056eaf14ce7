using UnityEngine;

namespace UnityEditor;

public static class EditorStyles
{
    public static GUIStyle label { get; } = new() { name = "label" };

    public static GUIStyle boldLabel { get; } = new() { name = "boldLabel", fontStyle = FontStyle.Bold };

    public static GUIStyle miniLabel { get; } = new() { name = "miniLabel" };

    public static GUIStyle miniButton { get; } = new() { name = "miniButton" };

    public static GUIStyle wordWrappedLabel { get; } = new() { name = "wordWrappedLabel", wordWrap = true };

    public static GUIStyle wordWrappedMiniLabel { get; } = new() { name = "wordWrappedMiniLabel", wordWrap = true };

    public static GUIStyle helpBox { get; } = new() { name = "helpBox", wordWrap = true };

    public static GUIStyle toolbar { get; } = new() { name = "toolbar" };

    public static GUIStyle toolbarButton { get; } = new() { name = "toolbarButton" };
}
