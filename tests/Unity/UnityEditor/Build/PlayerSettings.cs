namespace UnityEditor;

public static class PlayerSettings
{
    // On in Unity's templates.
    public static bool runInBackground { get; set; } = true;

    public static class Android
    {
        public static bool forceInternetPermission { get; set; }
    }
}
