using UnityEngine.SceneManagement;
using UnityEngine.StandIn;

namespace UnityEngine;

public sealed class GameObject : Object
{
    private bool _activeSelf = true;
    private readonly bool _isAsset = World.IsMakingAsset;

    public GameObject()
        : this("New Game Object")
    {
    }

    public GameObject(string name)
        : this(name, [])
    {
    }

    public GameObject(string name, params Type[] components)
    {
        SetName(name);
        transform = new Transform();
        transform.Attach(this);
        Components.Add(transform);
        foreach (Type type in components)
            AddComponent(type);
    }

    public Transform transform
    {
        get
        {
            Check();
            return field;
        }
    }

    public bool activeSelf
    {
        get
        {
            Check();
            return _activeSelf;
        }
    }

    public bool activeInHierarchy
    {
        get
        {
            Check();
            return IsActive;
        }
    }

    public int layer { get; set; }

    public string tag { get; set; } = "Untagged";

    public bool isStatic { get; set; }

    public Scene scene => new(IsKept ? "DontDestroyOnLoad" : IsAsset ? "" : transform.root.Owner!.SceneName ?? SceneManager.ActiveName);

    public GameObject gameObject => this;

    internal List<Component> Components { get; } = [];

    internal bool IsKept { get; set; }

    /// <summary>Of a root, its scene if that is not the active one.</summary>
    internal string? SceneName { get; set; }

    /// <summary>The serialised components whose scripts do not exist. Lists of components have null for each.</summary>
    internal IReadOnlyList<string> MissingScripts { get; set; } = [];

    /// <summary>True during SetActive, while OnEnable and OnDisable run. Meanwhile the object cannot gain or lose children.</summary>
    internal bool IsChanging { get; private set; }

    internal override bool IsAsset => _isAsset;

    internal bool IsActive
    {
        get
        {
            for (GameObject? item = this; item is not null; item = item.transform.Parent?.Owner)
            {
                if (!item._activeSelf || item._isAsset)
                    return false;
            }

            return true;
        }
    }

    public static GameObject? Find(string name) =>
        World.Objects.OfType<GameObject>().FirstOrDefault(item => item.activeInHierarchy && (name.Contains('/') ? item.transform.GetPath() == name.TrimStart('/') : item.name == name));

    public static GameObject? FindWithTag(string tag) => World.Objects.OfType<GameObject>().FirstOrDefault(item => item.activeInHierarchy && item.tag == tag);

    public static GameObject CreatePrimitive(PrimitiveType type)
    {
        var created = new GameObject(type.ToString());
        created.AddComponent<MeshFilter>().sharedMesh = StandIn.BuiltInResources.GetMesh(type);
        created.AddComponent<MeshRenderer>().sharedMaterial = StandIn.BuiltInResources.DefaultMaterial;
        created.AddComponent(type switch
        {
            PrimitiveType.Sphere => typeof(SphereCollider),
            PrimitiveType.Capsule or PrimitiveType.Cylinder => typeof(CapsuleCollider),
            PrimitiveType.Cube => typeof(BoxCollider),
            _ => typeof(MeshCollider),
        });
        return created;
    }

    public T AddComponent<T>()
        where T : Component => (T)AddComponent(typeof(T));

    public Component AddComponent(Type componentType)
    {
        Check();
        if (!typeof(Component).IsAssignableFrom(componentType) || componentType.IsAbstract)
            throw new ArgumentException($"{componentType} is not a component that can be added.", nameof(componentType));

        if (ComponentRules.IsSingle(componentType) && GetComponent(componentType) is not null)
        {
            Debug.LogWarning($"Can't add component '{componentType.Name}' to {name} because such a component is already added to the game object!");
            return null!;
        }

        foreach (Type needed in ComponentRules.GetRequired(componentType))
        {
            if (GetComponent(needed) is null)
                AddComponent(needed);
        }

        Component added = Create(componentType);
        if (added is MonoBehaviour script && !World.IsPlaying)
        {
            script.State.Call("Reset");
            script.State.Call("OnValidate");
        }

        (added as Behaviour)?.RefreshActivity();
        return added;
    }

    public T GetComponent<T>()
    {
        Check();
        foreach (Component item in Components)
        {
            if (item is T found)
                return found;
        }

        return default!;
    }

    public Component GetComponent(Type type)
    {
        Check();
        return Components.Find(type.IsInstanceOfType)!;
    }

    public bool TryGetComponent<T>(out T component)
    {
        component = GetComponent<T>();
        return component is not null;
    }

    public T[] GetComponents<T>()
    {
        Check();
        return [.. Components.OfType<T>(), .. GetMissing<T>()];
    }

    public void GetComponents<T>(List<T> results)
    {
        Check();
        results.Clear();
        foreach (Component item in Components)
        {
            if (item is T found)
                results.Add(found);
        }

        if (MissingScripts.Count > 0)
            results.AddRange(GetMissing<T>());
    }

    public T GetComponentInChildren<T>() => GetComponentInChildren<T>(false);

    // Allocates nothing.
    public T GetComponentInChildren<T>(bool includeInactive)
    {
        if ((includeInactive || IsActive || _isAsset) && GetComponent<T>() is { } own)
            return own;

        foreach (Transform child in transform.Children)
        {
            if (child.Owner!.GetComponentInChildren<T>(includeInactive) is { } found)
                return found;
        }

        return default!;
    }

    public T[] GetComponentsInChildren<T>() => GetComponentsInChildren<T>(false);

    public T[] GetComponentsInChildren<T>(bool includeInactive)
    {
        var found = new List<T>();
        GetComponentsInChildren(includeInactive, found);
        return [.. found];
    }

    public void GetComponentsInChildren<T>(bool includeInactive, List<T> results)
    {
        Check();
        results.Clear();
        Collect(includeInactive, results);
    }

    // Allocates nothing.
    public T GetComponentInParent<T>()
    {
        for (Transform? item = transform; item is not null; item = item.Parent)
        {
            if (item.Owner!.IsActive && item.Owner.GetComponent<T>() is { } found)
                return found;
        }

        return default!;
    }

    public T[] GetComponentsInParent<T>()
    {
        var found = new List<T>();
        for (Transform? item = transform; item is not null; item = item.Parent)
        {
            if (item.Owner!.IsActive)
                found.AddRange(item.Owner.Components.OfType<T>());
        }

        return [.. found];
    }

    public void SetActive(bool value)
    {
        Check();
        if (_activeSelf == value)
            return;

        _activeSelf = value;
        RefreshActivity();
    }

    public bool CompareTag(string tag) => this.tag == tag;

    public void SendMessage(string methodName)
    {
        foreach (MonoBehaviour script in Components.OfType<MonoBehaviour>().ToArray())
            script.State.Call(methodName);
    }

    internal Component Create(Type type)
    {
        var added = (Component)Activator.CreateInstance(type, nonPublic: true)!;
        added.Attach(this);
        Components.Add(added);
        return added;
    }

    /// <summary>Informs all scripts here and below of a change of activity, parents first.</summary>
    internal void RefreshActivity()
    {
        IsChanging = true;
        foreach (Component item in Components.ToArray())
        {
            if (!item.IsDestroyed)
                (item as Behaviour)?.RefreshActivity();
        }

        foreach (Transform child in transform.Children.ToArray())
        {
            if (!child.IsDestroyed)
                child.Owner!.RefreshActivity();
        }

        IsChanging = false;
    }

    internal override void DestroyNow()
    {
        _activeSelf = false;
        RefreshActivity();
        End();
        transform.Detach();
        Remove();
    }

    internal void SetActiveQuietly(bool value) => _activeSelf = value;

    private void End()
    {
        foreach (MonoBehaviour script in Components.OfType<MonoBehaviour>().ToArray())
            script.State.End();

        foreach (Transform child in transform.Children)
            child.Owner!.End();
    }

    private void Remove()
    {
        foreach (Transform child in transform.Children)
            child.Owner!.Remove();

        foreach (Component item in Components)
        {
            World.Remove(item);
            item.MarkDestroyed();
        }

        World.Remove(this);
        MarkDestroyed();
    }

    private IEnumerable<T> GetMissing<T>() =>
        typeof(T).IsAssignableFrom(typeof(MonoBehaviour)) ? Enumerable.Repeat(default(T)!, MissingScripts.Count) : [];

    private void Collect<T>(bool includeInactive, List<T> found)
    {
        if (!includeInactive && !IsActive && !_isAsset)
            return;

        foreach (Component item in Components)
        {
            if (item is T match)
                found.Add(match);
        }

        if (MissingScripts.Count > 0)
            found.AddRange(GetMissing<T>());

        foreach (Transform child in transform.Children)
            child.Owner!.Collect(includeInactive, found);
    }
}
