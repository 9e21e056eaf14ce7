using UnityEngine.StandIn;

namespace UnityEngine;

public class Component : Object
{
    private GameObject? _gameObject;

    public Transform transform => gameObject.transform;

    public GameObject gameObject
    {
        get
        {
            Check();
            return _gameObject ?? throw new MissingComponentException("The component is on no GameObject: scripts may use theirs from Awake on, not in a constructor.");
        }
    }

    public string tag
    {
        get => gameObject.tag;
        set => gameObject.tag = value;
    }

    internal override bool IsAsset => _gameObject is null || _gameObject.IsAsset;

    internal GameObject? Owner => _gameObject;

    public bool CompareTag(string tag) => gameObject.CompareTag(tag);

    public T GetComponent<T>() => gameObject.GetComponent<T>();

    public Component GetComponent(Type type) => gameObject.GetComponent(type);

    public bool TryGetComponent<T>(out T component) => gameObject.TryGetComponent(out component);

    public T[] GetComponents<T>() => gameObject.GetComponents<T>();

    public void GetComponents<T>(List<T> results) => gameObject.GetComponents(results);

    public T GetComponentInChildren<T>() => gameObject.GetComponentInChildren<T>();

    public T GetComponentInChildren<T>(bool includeInactive) => gameObject.GetComponentInChildren<T>(includeInactive);

    public T[] GetComponentsInChildren<T>() => gameObject.GetComponentsInChildren<T>();

    public T[] GetComponentsInChildren<T>(bool includeInactive) => gameObject.GetComponentsInChildren<T>(includeInactive);

    public void GetComponentsInChildren<T>(bool includeInactive, List<T> result) => gameObject.GetComponentsInChildren(includeInactive, result);

    public T GetComponentInParent<T>() => gameObject.GetComponentInParent<T>();

    public T[] GetComponentsInParent<T>() => gameObject.GetComponentsInParent<T>();

    public void SendMessage(string methodName) => gameObject.SendMessage(methodName);

    internal void Attach(GameObject owner) => _gameObject = owner;

    internal override string GetName() => _gameObject?.GetName() ?? "";

    internal override void SetName(string value) => gameObject.SetName(value);

    internal override bool CanDestroy()
    {
        Component? dependant = gameObject.Components.FirstOrDefault(other => other != this && ComponentRules.Requires(other.GetType(), GetType()));
        if (dependant is null)
            return true;

        Debug.LogError($"Can't remove {GetType().Name} because {dependant.GetType().Name} depends on it");
        return false;
    }

    internal override void DestroyNow()
    {
        _gameObject?.Components.Remove(this);
        base.DestroyNow();
    }
}
