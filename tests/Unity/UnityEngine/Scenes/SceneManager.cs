using UnityEngine.Events;
using UnityEngine.StandIn;

namespace UnityEngine.SceneManagement;

public class SceneManager
{
    public static event UnityAction<Scene, LoadSceneMode>? sceneLoaded;

    public static event UnityAction<Scene>? sceneUnloaded;

    public static event UnityAction<Scene, Scene>? activeSceneChanged;

    public static int sceneCount => 1 + Others.Count;

    internal static string ActiveName { get; set; } = "Untitled";

    internal static string? Requested { get; set; }

    /// <summary>The names of scenes that are open beside the active one.</summary>
    internal static List<string> Others { get; } = [];

    /// <summary>The files of saved scenes, by name.</summary>
    internal static Dictionary<string, string> Paths { get; } = [];

    internal static HashSet<string> Dirty { get; } = [];

    public static Scene GetActiveScene() => new(ActiveName);

    public static Scene GetSceneAt(int index) => index == 0 ? GetActiveScene() : new(Others[index - 1]);

    public static void MoveGameObjectToScene(GameObject go, Scene scene)
    {
        if (go.transform.parent is not null)
            throw new ArgumentException("Gameobject is not a root in a scene", nameof(go));

        go.SceneName = scene.name == ActiveName ? null : scene.name;
    }

    /// <summary>Changes the scene with the next frame, as in the engine.</summary>
    public static void LoadScene(string sceneName) => Requested = sceneName;

    /// <summary>Destroys the content of the scene and creates that of the other one.</summary>
    internal static void Change(string name, Action? build)
    {
        Scene left = GetActiveScene();
        foreach (GameObject root in World.GetRoots().Where(static item => !item.IsKept).ToArray())
        {
            if (!root.IsDestroyed)
                root.DestroyNow();
        }

        sceneUnloaded?.Invoke(left);
        ActiveName = name;
        Requested = null;
        activeSceneChanged?.Invoke(left, GetActiveScene());
        build?.Invoke();
        sceneLoaded?.Invoke(GetActiveScene(), LoadSceneMode.Single);
    }

    internal static void ForgetListeners()
    {
        (sceneLoaded, sceneUnloaded, activeSceneChanged) = (null, null, null);
        ActiveName = "Untitled";
        Requested = null;
        Others.Clear();
        Paths.Clear();
        Dirty.Clear();
    }
}

public enum LoadSceneMode
{
    Single,
    Additive,
}

public readonly struct Scene : IEquatable<Scene>
{
    internal Scene(string name) => this.name = name;

    public string name { get; }

    /// <summary>Empty for a scene that was never saved.</summary>
    public string path => SceneManager.Paths.TryGetValue(name ?? "", out string? saved) ? saved : "";

    public bool isDirty => SceneManager.Dirty.Contains(name);

    public bool isLoaded => IsValid();

    public static bool operator ==(Scene lhs, Scene rhs) => lhs.Equals(rhs);

    public static bool operator !=(Scene lhs, Scene rhs) => !lhs.Equals(rhs);

    public bool IsValid() => !string.IsNullOrEmpty(name);

    public GameObject[] GetRootGameObjects()
    {
        Scene scene = this;
        return [.. World.GetRoots().Where(item => item.scene == scene)];
    }

    public override bool Equals(object? other) => other is Scene scene && Equals(scene);

    public bool Equals(Scene other) => name == other.name;

    public override int GetHashCode() => StringComparer.Ordinal.GetHashCode(name ?? "");
}
