using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public sealed class Selection
{
    private static Object[] _objects = [];

    public static Action? selectionChanged { get; set; }

    public static Object[] objects
    {
        get => _objects;

        set
        {
            _objects = value;
            selectionChanged?.Invoke();
        }
    }

    public static Object? activeObject
    {
        get => _objects.FirstOrDefault();
        set => objects = value == null ? [] : [value];
    }

    public static GameObject? activeGameObject
    {
        get => activeObject as GameObject;
        set => activeObject = value;
    }

    public static Transform? activeTransform
    {
        get => activeGameObject?.transform;
        set => activeObject = value?.gameObject;
    }

    public static GameObject[] gameObjects => [.. _objects.OfType<GameObject>()];

    public static Transform[] transforms => [.. gameObjects.Select(static item => item.transform)];

    internal static void Forget()
    {
        selectionChanged = null;
        _objects = [];
    }
}
