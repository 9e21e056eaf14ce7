namespace UnityEditor;

/// <summary>The number of each loaded object in its file.</summary>
internal static class FileIds
{
    // By the object's own number, because == of destroyed objects is special.
    private static readonly Dictionary<int, (UnityEngine.Object Item, FileId Id)> Known = [];

    public static void Set(UnityEngine.Object item, FileId id) => Known[item.GetInstanceID()] = (item, id);

    public static FileId? Of(UnityEngine.Object item) => Known.TryGetValue(item.GetInstanceID(), out (UnityEngine.Object Item, FileId Id) found) ? found.Id : null;

    public static UnityEngine.Object? Find(string guid, long local, long instance) => Known.Values
        .FirstOrDefault(entry => !entry.Item.IsDestroyed && entry.Id.File == guid && entry.Id.Local == local && entry.Id.Instance == instance).Item;

    /// <summary>Objects of instances whose objects in the prefab are gone.</summary>
    public static UnityEngine.Object[] FindOrphans() =>
        [.. Known.Values.Where(static entry => !entry.Item.IsDestroyed && entry.Id.Source is { IsDestroyed: true }).Select(static entry => entry.Item)];

    public static void Clear() => Known.Clear();
}
