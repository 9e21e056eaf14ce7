using UnityEngine.StandIn;

namespace UnityEngine;

public class Object
{
    private readonly int _id;
    private string _name = "";

    public Object()
    {
        MainThread.Check("Constructor");
        _id = World.Add(this);
    }

    public string name
    {
        get
        {
            Check();
            return GetName();
        }

        set
        {
            Check();
            SetName(value);
        }
    }

    public HideFlags hideFlags { get; set; }

    internal bool IsDestroyed { get; private set; }

    internal virtual bool IsAsset => true;

    public static void Destroy(Object obj) => Destroy(obj, 0);

    public static void Destroy(Object obj, float t)
    {
        MainThread.Check();
        if (obj is null || obj.IsDestroyed)
            return;

        if (!World.IsPlaying)
            Debug.LogError("Destroy may not be called from edit mode! Use DestroyImmediate instead.");
        else if (obj.CanDestroy())
            World.DestroyLater(obj, Time.time + t);
    }

    public static void DestroyImmediate(Object obj) => DestroyImmediate(obj, false);

    public static void DestroyImmediate(Object obj, bool allowDestroyingAssets)
    {
        MainThread.Check();
        if (obj is not null && !obj.IsDestroyed && obj.CanDestroy())
            obj.DestroyNow();
    }

    public static void DontDestroyOnLoad(Object target)
    {
        MainThread.Check();
        GameObject? item = target switch { GameObject own => own, Component part => part.gameObject, _ => null };
        if (item is null)
            return;

        if (item.transform.parent is null)
            item.IsKept = true;
        else
            Debug.LogWarning("DontDestroyOnLoad only works for root GameObjects or components on root GameObjects.");
    }

    public static T Instantiate<T>(T original)
        where T : Object => Cloning.Clone(original, null, static _ => { });

    public static T Instantiate<T>(T original, Transform parent)
        where T : Object => Instantiate(original, parent, false);

    public static T Instantiate<T>(T original, Transform parent, bool worldPositionStays)
        where T : Object => Cloning.Clone(original, clone => clone.SetParent(parent, worldPositionStays), static _ => { });

    public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation)
        where T : Object => Cloning.Clone(original, clone => clone.SetPositionAndRotation(position, rotation), static _ => { });

    public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation, Transform parent)
        where T : Object => Cloning.Clone(
            original,
            clone =>
            {
                clone.SetParent(parent, false);
                clone.SetPositionAndRotation(position, rotation);
            },
            static _ => { });

    public static T? FindObjectOfType<T>()
        where T : Object => FindObjectsOfType<T>().FirstOrDefault();

    public static T? FindObjectOfType<T>(bool includeInactive)
        where T : Object => FindObjectsOfType<T>(includeInactive).FirstOrDefault();

    public static T[] FindObjectsOfType<T>()
        where T : Object => FindObjectsOfType<T>(false);

    public static T[] FindObjectsOfType<T>(bool includeInactive)
        where T : Object
    {
        MainThread.Check();
        return [.. World.Objects.OfType<T>().Where(item => item switch
        {
            GameObject own => !own.IsAsset && (includeInactive || own.activeInHierarchy),
            Component part => !part.gameObject.IsAsset && (includeInactive || part.gameObject.activeInHierarchy),
            _ => true,
        })];
    }

    public static bool operator ==(Object? x, Object? y) => ReferenceEquals(Living(x), Living(y));

    public static bool operator !=(Object? x, Object? y) => !(x == y);

    public static implicit operator bool(Object? exists) => Living(exists) is not null;

    public int GetInstanceID() => _id;

    public override bool Equals(object? other) => other is null ? IsDestroyed : other is Object item && this == item;

    public override int GetHashCode() => _id;

    public override string ToString() => IsDestroyed ? "null" : $"{GetName()} ({GetType().FullName})";

    internal virtual string GetName() => _name;

    internal virtual void SetName(string value) => _name = value;

    internal virtual bool CanDestroy() => true;

    internal virtual void DestroyNow()
    {
        World.Remove(this);
        MarkDestroyed();
    }

    internal void MarkDestroyed(bool isDestroyed = true) => IsDestroyed = isDestroyed;

    /// <summary>The first check of every call into the engine: the thread, and that the object still exists.</summary>
    internal void Check([System.Runtime.CompilerServices.CallerMemberName] string member = "")
    {
        MainThread.Check(member);
        if (IsDestroyed)
            throw new MissingReferenceException($"The object of type '{GetType().Name}' has been destroyed but you are still trying to access it.");
    }

    private static Object? Living(Object? item) => item is null || item.IsDestroyed ? null : item;
}
