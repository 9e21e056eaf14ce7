using UnityEngine;

namespace UnityEditor;

public static class Selection
{
    public static UnityEngine.Object[] objects { get; set; } = [];

    public static UnityEngine.Object? activeObject
    {
        get => objects.FirstOrDefault();
        set => objects = value is null ? [] : [value];
    }

    public static GameObject? activeGameObject
    {
        get => activeObject as GameObject;
        set => activeObject = value;
    }

    public static GameObject[] gameObjects => [.. objects.OfType<GameObject>().Where(static item => item != null)];
}
