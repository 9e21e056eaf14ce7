using UnityEngine;
using UnityEngine.SceneManagement;
using UnityEngine.StandIn;

namespace UnityEditor.SceneManagement;

public class EditorSceneManager : SceneManager
{
    /// <summary>For tests: the paths of the scenes that were opened, in order.</summary>
    internal static List<string> Opened { get; } = [];

    public static Scene OpenScene(string scenePath, OpenSceneMode mode)
    {
        string name = Path.GetFileNameWithoutExtension(scenePath);
        Opened.Add(scenePath);
        if (mode == OpenSceneMode.Single)
        {
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
        ObjectFile.Save(scene.path, scene.GetRootGameObjects());
        Dirty.Remove(scene.name);
        return true;
    }

    public static bool CloseScene(Scene scene, bool removeScene)
    {
        foreach (GameObject root in scene.GetRootGameObjects())
            root.DestroyNow();

        Dirty.Remove(scene.name);
        return Others.Remove(scene.name);
    }

    public static bool MarkSceneDirty(Scene scene) => Dirty.Add(scene.name);
}

public enum OpenSceneMode
{
    Single,
    Additive,
}
