using UnityEngine;

namespace UnityEditor;

public class EditorWindow : ScriptableObject
{
    private static readonly List<EditorWindow> Opened = [];

    public GUIContent titleContent { get; set; } = new("");

    public Vector2 minSize { get; set; }

    public Rect position { get; set; } = new(0, 0, 400, 600);

    /// <summary>For tests: the number of requested repaints.</summary>
    public int Repaints { get; private set; }

    public static T GetWindow<T>()
        where T : EditorWindow
    {
        if (Opened.OfType<T>().FirstOrDefault() is { } open)
            return open;

        T created = CreateInstance<T>();
        Opened.Add(created);
        return created;
    }

    public void Repaint() => Repaints++;

    public void Close()
    {
        Opened.Remove(this);
        DestroyImmediate(this);
    }
}
