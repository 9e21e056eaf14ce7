using UnityEngine;

namespace UnityEditor;

/// <summary>A script file. Its class is null if it does not compile.</summary>
public class MonoScript : TextAsset
{
    private readonly Type? _type;

    internal MonoScript(Type type) => _type = type;

    public Type? GetClass() => _type;
}
