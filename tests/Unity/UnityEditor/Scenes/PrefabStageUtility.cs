namespace UnityEditor.SceneManagement;

public static class PrefabStageUtility
{
    /// <summary>Null if no prefab is open.</summary>
    public static PrefabStage? GetCurrentPrefabStage() => PrefabStage.Current;
}
