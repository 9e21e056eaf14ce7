namespace UnityEditor;

public static class PrefabUtility
{
    /// <summary>Does nothing, because there are no prefab instances.</summary>
    public static void RecordPrefabInstancePropertyModifications(UnityEngine.Object targetObject)
    {
    }
}
