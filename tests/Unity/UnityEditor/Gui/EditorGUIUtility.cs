namespace UnityEditor;

public static class EditorGUIUtility
{
    public static bool isProSkin { get; set; } = true;

    public static float labelWidth { get; set; } = 150;

    public static float singleLineHeight => 18;

    /// <summary>For tests: the object shown last in the project window or the hierarchy.</summary>
    public static UnityEngine.Object? Pinged { get; set; }

    public static void PingObject(UnityEngine.Object? obj) => Pinged = obj;
}
