namespace UnityEditor;

public static class EditorUtility
{
    /// <summary>For tests: the user's choice in the next file dialog. Empty for Cancel.</summary>
    public static string NextFile { get; set; } = "";

    /// <summary>For tests: the paths shown in the system's file manager.</summary>
    public static List<string> Revealed { get; } = [];

    /// <summary>For tests: what the progress bar has shown, and whether it is still there.</summary>
    public static List<float> Progress { get; } = [];

    public static bool IsShowingProgress { get; private set; }

    public static void DisplayProgressBar(string title, string info, float progress)
    {
        Progress.Add(progress);
        IsShowingProgress = true;
    }

    public static void ClearProgressBar() => IsShowingProgress = false;

    public static bool IsPersistent(UnityEngine.Object target) => AssetDatabase.Contains(target);

    public static void SetDirty(UnityEngine.Object target)
    {
    }

    public static string OpenFilePanel(string title, string directory, string extension) => NextFile;

    public static string OpenFilePanelWithFilters(string title, string directory, string[] filters) => filters.Length % 2 == 0
        ? NextFile
        : throw new ArgumentException("Filters must be pairs of a name and extensions.", nameof(filters));

    public static void RevealInFinder(string path) => Revealed.Add(path);
}
