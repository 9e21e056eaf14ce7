using UnityEngine;
using UnityEngine.SceneManagement;

namespace UnityEditor.SceneManagement;

/// <summary>A prefab that is open for editing, in a preview scene.</summary>
public sealed class PrefabStage : ScriptableObject
{
    /// <summary>Occurs before the prefab is written.</summary>
    public static event Action<GameObject>? prefabSaving;

    public Scene scene { get; private set; }

    public GameObject prefabContentsRoot { get; private set; } = null!;

    internal static PrefabStage? Current { get; private set; }

    /// <summary>For tests: opens the prefab that consists of an object.</summary>
    internal static PrefabStage Open(GameObject root)
    {
        PrefabStage stage = CreateInstance<PrefabStage>();
        (stage.scene, stage.prefabContentsRoot) = (EditorSceneManager.NewPreviewScene(), root);
        SceneManager.MoveGameObjectToScene(root, stage.scene);
        return Current = stage;
    }

    internal static void RaiseSaving(GameObject prefab) => prefabSaving?.Invoke(prefab);

    internal static void Forget() => (prefabSaving, Current) = (null, null);
}
