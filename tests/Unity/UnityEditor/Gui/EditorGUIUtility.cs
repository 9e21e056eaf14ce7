namespace UnityEditor;

public static class EditorGUIUtility
{
    public static bool isProSkin { get; set; } = true;

    public static float labelWidth { get; set; } = 150;

    public static float singleLineHeight => 18;

    public static void PingObject(UnityEngine.Object obj)
    {
    }
}
