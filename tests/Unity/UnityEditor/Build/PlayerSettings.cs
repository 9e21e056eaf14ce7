namespace UnityEditor;

public static class PlayerSettings
{
    public static class Android
    {
        public static bool forceInternetPermission { get; set; }
    }
}
