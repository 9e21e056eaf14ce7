using UnityEngine;
using UnityEngine.SceneManagement;
using UnityEngine.StandIn;

namespace UnityEditor.SceneManagement;

public class EditorSceneManager : SceneManager
{
    public delegate void SceneSavingCallback(Scene scene, string path);

    public delegate void SceneClosingCallback(Scene scene, bool removingScene);

    /// <summary>Occurs before the scene is written.</summary>
    public static event SceneSavingCallback? sceneSaving;

    /// <summary>Occurs before the objects of the scene are destroyed.</summary>
    public static event SceneClosingCallback? sceneClosing;

    /// <summary>For tests: the paths of the scenes that were opened, in order.</summary>
    internal static List<string> Opened { get; } = [];

    private static HashSet<string> Previews { get; } = [];

    public static Scene OpenScene(string scenePath, OpenSceneMode mode)
    {
        string name = Path.GetFileNameWithoutExtension(scenePath);
        Opened.Add(scenePath);
        if (mode == OpenSceneMode.Single)
        {
            for (int i = sceneCount - 1; i >= 0; i--)
                sceneClosing?.Invoke(GetSceneAt(i), true);

            foreach (GameObject root in World.GetRoots().ToArray())
                root.DestroyNow();

            Undo.ClearAll();
            Others.Clear();
            ActiveName = name;
        }
        else
        {
            Others.Add(name);
        }

        Paths[name] = scenePath;
        foreach (GameObject root in ObjectFile.Load(scenePath, isAsset: false))
            root.SceneName = mode == OpenSceneMode.Single ? null : name;

        return mode == OpenSceneMode.Single ? GetActiveScene() : GetSceneAt(sceneCount - 1);
    }

    public static bool SaveScene(Scene scene)
    {
        sceneSaving?.Invoke(scene, scene.path);
        ObjectFile.Save(scene.path, scene.GetRootGameObjects());
        Dirty.Remove(scene.name);
        return true;
    }

    public static bool CloseScene(Scene scene, bool removeScene)
    {
        sceneClosing?.Invoke(scene, removeScene);
        foreach (GameObject root in scene.GetRootGameObjects())
            root.DestroyNow();

        Dirty.Remove(scene.name);
        return Others.Remove(scene.name);
    }

    public static bool MarkSceneDirty(Scene scene) => Dirty.Add(scene.name);

    /// <summary>Opens a scene that the user does not see. Its objects are found like those of other scenes.</summary>
    public static Scene NewPreviewScene()
    {
        string name = $"Preview Scene {Previews.Count + 1}";
        Previews.Add(name);
        return new Scene(name);
    }

    public static bool IsPreviewScene(Scene scene) => Previews.Contains(scene.name);

    internal static void Forget()
    {
        (sceneSaving, sceneClosing) = (null, null);
        Previews.Clear();
    }
}

public enum OpenSceneMode
{
    Single,
    Additive,
}
