namespace UnityEditor;

public static class PrefabUtility
{
    /// <summary>Without prefab instances there is nothing to keep.</summary>
    public static void RecordPrefabInstancePropertyModifications(UnityEngine.Object targetObject)
    {
    }
}
