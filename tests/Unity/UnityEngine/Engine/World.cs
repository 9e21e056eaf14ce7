namespace UnityEngine.StandIn;

/// <summary>All live state: objects, scripts in execution order, and objects that wait to be destroyed.</summary>
internal static class World
{
    private static readonly List<Object> _objects = [];
    private static readonly List<(Object Object, float Time)> _doomed = [];
    private static int _lastId;

    public static IReadOnlyList<Object> Objects => _objects;

    public static bool IsPlaying { get; set; }

    /// <summary>Whether new objects are assets, such as prefabs: they are in no scene and their scripts do not run.</summary>
    public static bool IsMakingAsset { get; set; }

    public static int Add(Object item)
    {
        _objects.Add(item);
        return --_lastId;
    }

    public static void Remove(Object item) => _objects.Remove(item);

    /// <summary>Brings a destroyed object back, as Undo does.</summary>
    public static void Restore(Object item)
    {
        item.MarkDestroyed(false);
        _objects.Add(item);
    }

    public static IEnumerable<GameObject> GetRoots() =>
        _objects.OfType<GameObject>().Where(static item => !item.IsAsset && item.transform.parent is null);

    public static void DestroyLater(Object item, float time) => _doomed.Add((item, time));

    /// <summary>Destroys objects that are due, in the order of the requests.</summary>
    public static void DestroyDue(float time)
    {
        for (int i = 0; i < _doomed.Count; i++)
        {
            (Object item, float due) = _doomed[i];
            if (due > time)
                continue;

            _doomed.RemoveAt(i--);
            if (!item.IsDestroyed)
                item.DestroyNow();
        }
    }

    /// <summary>Discards everything without notice, so that the next test starts with an empty project.</summary>
    public static void Clear()
    {
        foreach (Object item in _objects)
            item.MarkDestroyed();

        _objects.Clear();
        _doomed.Clear();
        IsPlaying = false;
        IsMakingAsset = false;
    }
}
