using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

public static class PrefabUtility
{
    private static readonly List<Object> _recorded = [];

    /// <summary>For tests: the objects whose modifications were recorded, the oldest first.</summary>
    public static IReadOnlyList<Object> Recorded => _recorded;

    /// <summary>Instances keep no list of modifications. A test sees that Unity would have been told.</summary>
    public static void RecordPrefabInstancePropertyModifications(Object targetObject) => _recorded.Add(targetObject);

    /// <returns>The object of the prefab, or null for one that is in no prefab or was added to an instance.</returns>
    public static T? GetCorrespondingObjectFromSource<T>(T componentOrGameObject)
        where T : Object => FileIds.Of(componentOrGameObject)?.Source as T;

    /// <summary>Saves a prefab. Instances lose the components that it lost; the stand-in does not add what it gained.</summary>
    public static GameObject SavePrefabAsset(GameObject asset) => SavePrefabAsset(asset, out _);

    /// <summary>Unity refuses to save a prefab with a missing script.</summary>
    public static GameObject SavePrefabAsset(GameObject asset, out bool savedSuccessfully)
    {
        savedSuccessfully = asset.GetComponentsInChildren<Transform>(true)
            .All(static child => GameObjectUtility.GetMonoBehavioursWithMissingScriptCount(child.gameObject) == 0);
        if (!savedSuccessfully)
            return asset;

        if (asset.transform.parent is not null || AssetDatabase.GetAssetPath(asset) is not { Length: > 0 } path)
            throw new ArgumentException("Can't save a Prefab that is not the root of an asset", nameof(asset));

        ObjectFile.Save(path, [asset]);
        foreach (Object orphan in FileIds.FindOrphans())
            Object.DestroyImmediate(orphan, true);

        return asset;
    }

    internal static void Forget() => _recorded.Clear();
}
