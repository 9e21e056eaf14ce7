using UnityEngine.StandIn;

namespace UnityEngine;

public static class Resources
{
    internal static Dictionary<string, Object> Assets { get; } = [];

    public static T? Load<T>(string path)
        where T : Object => Assets.TryGetValue(path, out Object? found) ? found as T : null;

    public static T? GetBuiltinResource<T>(string path)
        where T : Object => Activator.CreateInstance(typeof(T), nonPublic: true) as T;

    public static T[] FindObjectsOfTypeAll<T>() => [.. World.Objects.OfType<T>()];

    public static AsyncOperation UnloadUnusedAssets()
    {
        var operation = new AsyncOperation();
        operation.Complete();
        return operation;
    }
}
