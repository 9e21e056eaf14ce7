using UnityEngine;

namespace UnityEditor.SceneManagement;

public static class StageUtility
{
    /// <summary>While a prefab is open, the object becomes a part of it. New objects are in the active scene otherwise.</summary>
    public static void PlaceGameObjectInCurrentStage(GameObject gameObject)
    {
        if (PrefabStage.Current is { } stage)
            gameObject.transform.SetParent(stage.prefabContentsRoot.transform, worldPositionStays: true);
    }
}
