using UnityEngine;

namespace UnityEditor.SceneManagement;

/// <summary>A prefab that is open for editing.</summary>
public sealed class PrefabStage
{
    /// <summary>Occurs before the prefab is written.</summary>
    public static event Action<GameObject>? prefabSaving;

    internal static void RaiseSaving(GameObject prefab) => prefabSaving?.Invoke(prefab);

    internal static void Forget() => prefabSaving = null;
}
