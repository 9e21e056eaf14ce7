using UnityEngine.StandIn;

namespace UnityEngine;

public static class Application
{
    public delegate void LogCallback(string condition, string stackTrace, LogType type);

    public static event Action? quitting;

    public static event Func<bool>? wantsToQuit;

    public static event Action<bool>? focusChanged;

    public static event LogCallback? logMessageReceived;

    public static event LogCallback? logMessageReceivedThreaded;

    public static bool isPlaying => World.IsPlaying;

    public static bool isEditor { get; internal set; } = true;

    public static bool isBatchMode => false;

    public static bool isFocused { get; private set; } = true;

    public static bool isMobilePlatform => platform is RuntimePlatform.Android or RuntimePlatform.IPhonePlayer;

    public static bool runInBackground { get; set; }

    public static int targetFrameRate { get; set; } = -1;

    public static RuntimePlatform platform { get; internal set; } = RuntimePlatform.LinuxEditor;

    public static string unityVersion => "2021.3.0f1";

    public static string productName => "Stand-in";

    public static string companyName => "NeuronMocap";

    public static string version => "1.0";

    public static string dataPath => Main(Path.Combine(Folder, "Assets"));

    public static string persistentDataPath => Main(Path.Combine(Folder, "Persistent"));

    public static string streamingAssetsPath => Main(Path.Combine(Folder, "Assets", "StreamingAssets"));

    public static string temporaryCachePath => Main(Directory.CreateDirectory(Path.Combine(Folder, "Temp")).FullName);

    public static NetworkReachability internetReachability => NetworkReachability.ReachableViaLocalAreaNetwork;

    internal static string Folder { get; set; } = Path.Combine(Path.GetTempPath(), "unity-stand-in");

    public static void Quit() => Quit(0);

    public static void Quit(int exitCode) => QuitRequested = !isEditor && wantsToQuit?.Invoke() != false;

    public static void OpenURL(string url) => Opened.Add(url);

    internal static bool QuitRequested { get; set; }

    internal static List<string> Opened { get; } = [];

    internal static void RaiseQuitting() => Raise(quitting);

    internal static void RaiseFocus(bool isFocused)
    {
        Application.isFocused = isFocused;
        if (focusChanged is { } handler)
            Raise(() => handler(isFocused));
    }

    internal static void RaiseLog(LogEntry entry)
    {
        string stack = entry.Exception?.StackTrace ?? "";
        logMessageReceivedThreaded?.Invoke(entry.Message, stack, entry.Type);
        if (MainThread.IsCurrent)
            logMessageReceived?.Invoke(entry.Message, stack, entry.Type);
    }

    /// <summary>Removes all listeners, as a domain reload does.</summary>
    internal static void ForgetListeners() =>
        (quitting, wantsToQuit, focusChanged, logMessageReceived, logMessageReceivedThreaded) = (null, null, null, null, null);

    private static string Main(string path)
    {
        MainThread.Check("Application");
        return path;
    }

    private static void Raise(Action? handlers)
    {
        foreach (Delegate handler in handlers?.GetInvocationList() ?? [])
            ScriptCallbacks.Run((Action)handler, null!);
    }
}

public enum RuntimePlatform
{
    OSXEditor = 0,
    OSXPlayer = 1,
    WindowsPlayer = 2,
    WindowsEditor = 7,
    IPhonePlayer = 8,
    Android = 11,
    LinuxPlayer = 13,
    LinuxEditor = 16,
    WebGLPlayer = 17,
    tvOS = 31,
}

public enum NetworkReachability
{
    NotReachable,
    ReachableViaCarrierDataNetwork,
    ReachableViaLocalAreaNetwork,
}
