using System.Reflection;

namespace UnityEngine.StandIn;

/// <summary>Copies objects with all their descendants, like Instantiate.</summary>
internal static class Cloning
{
    public static T Clone<T>(T original, Action<Transform>? place, Action<GameObject> prepare)
        where T : Object
    {
        MainThread.Check("Instantiate");
        if (original is null || original.IsDestroyed)
            throw new ArgumentException("The Object you want to instantiate is null.", nameof(original));

        GameObject? source = original switch { GameObject own => own, Component part => part.gameObject, _ => null };
        if (source is null)
            return (T)CloneAsset(original);

        var copies = new Dictionary<Object, Object>();
        GameObject copy = CloneTree(source, copies);
        copy.name = source.name + "(Clone)";
        foreach ((Object from, Object to) in copies)
        {
            if (from is Component)
                CopyComponent(from, to, item => copies.TryGetValue(item, out Object? inside) ? inside : item);
        }

        prepare(copy);
        place?.Invoke(copy.transform);
        Wake(copy.GetComponentsInChildren<MonoBehaviour>(true).Where(static script => script is not null));
        copy.RefreshActivity();
        return (T)copies[original];
    }

    /// <summary>Calls Awake and OnEnable in execution order, as when a scene is loaded.</summary>
    public static void Wake(IEnumerable<MonoBehaviour> scripts)
    {
        foreach (MonoBehaviour script in scripts.OrderBy(static script => script.State.Order).ToArray())
        {
            if (!script.IsDestroyed)
                script.RefreshActivity();
        }
    }

    private static Object CloneAsset(Object original)
    {
        var copy = (Object)Activator.CreateInstance(original.GetType(), nonPublic: true)!;
        CopyComponent(original, copy, static item => item);
        copy.name = original.name + "(Clone)";
        return copy;
    }

    private static GameObject CloneTree(GameObject source, Dictionary<Object, Object> copies)
    {
        // Inactive until everything is in place, because no script may run before.
        var copy = new GameObject(source.name) { layer = source.layer, tag = source.tag, MissingScripts = source.MissingScripts };
        copy.SetActiveQuietly(false);
        copies.Add(source, copy);
        copies.Add(source.transform, copy.transform);
        foreach (Component item in source.Components.Skip(1))
            copies.Add(item, copy.Create(item.GetType()));

        foreach (Transform child in source.transform.Children)
            CloneTree(child.gameObject, copies).transform.SetParent(copy.transform, false);

        copy.SetActiveQuietly(source.activeSelf);
        return copy;
    }

    // For scripts, copies the fields that Unity serialises. For engine components, copies everything except identity and location.
    private static void CopyComponent(Object from, Object to, Func<Object, Object> map)
    {
        for (Type? type = from.GetType(); type is not null && type != typeof(Component) && type != typeof(Object); type = type.BaseType)
        {
            if (type.Assembly != typeof(Object).Assembly || type == typeof(MonoBehaviour))
                continue;

            foreach (FieldInfo field in type.GetFields(BindingFlags.DeclaredOnly | BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
            {
                if (!field.IsDefined(typeof(NonSerializedAttribute)))
                    field.SetValue(to, field.GetValue(from) is Object item ? map(item) : field.GetValue(from));
            }
        }

        Serialization.CopyFields(from, to, map);
    }
}
