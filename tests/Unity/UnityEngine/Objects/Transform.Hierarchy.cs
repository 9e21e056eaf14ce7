using System.Collections;

namespace UnityEngine;

// The place among other transforms.
public partial class Transform : IEnumerable
{
    public Transform? parent
    {
        get
        {
            Check();
            return Parent;
        }

        set => SetParent(value, true);
    }

    public int childCount
    {
        get
        {
            Check();
            return Children.Count;
        }
    }

    public Transform root => parent is null ? this : parent.root;

    [field: NonSerialized]
    internal Transform? Parent { get; private set; }

    [field: NonSerialized]
    internal List<Transform> Children { get; } = [];

    public void SetParent(Transform? p) => SetParent(p, true);

    public void SetParent(Transform? parent, bool worldPositionStays)
    {
        Check();
        if (parent is not null)
        {
            parent.Check();
            if (parent.IsChildOf(this))
            {
                Debug.LogError("Transform resides in the hierarchy of its own parent.");
                return;
            }
        }

        if (ReferenceEquals(parent, Parent))
            return;

        if (Parent?.Owner is { IsChanging: true } || parent?.Owner is { IsChanging: true })
        {
            Debug.LogError($"Cannot set the parent of the GameObject '{name}' while activating or deactivating the parent GameObject '{(parent ?? Parent)!.name}'.");
            return;
        }

        Vector3 worldPosition = position;
        Quaternion worldRotation = rotation;
        Vector3 worldScale = lossyScale;
        bool wasActive = Owner!.IsActive;
        Detach();
        Parent = parent;
        parent?.Children.Add(this);
        if (parent is not null)
            Owner.IsKept = false;

        if (worldPositionStays)
        {
            position = worldPosition;
            rotation = worldRotation;
            localScale = Vector3.one;
            Vector3 unit = lossyScale;
            localScale = new Vector3(Divide(worldScale.x, unit.x), Divide(worldScale.y, unit.y), Divide(worldScale.z, unit.z));
        }

        MarkChanged();
        if (wasActive != Owner.IsActive)
            Owner.RefreshActivity();
    }

    public Transform GetChild(int index)
    {
        Check();
        return index >= 0 && index < Children.Count ? Children[index] : throw new UnityException("Transform child out of bounds");
    }

    public Transform? Find(string n)
    {
        Check();
        Transform? found = this;
        foreach (string part in n.Split('/'))
        {
            found = part == ".." ? found.Parent : found.Children.Find(child => child.name == part);
            if (found is null)
                return null;
        }

        return found;
    }

    public bool IsChildOf(Transform parent)
    {
        for (Transform? item = this; item is not null; item = item.Parent)
        {
            if (ReferenceEquals(item, parent))
                return true;
        }

        return false;
    }

    public void DetachChildren()
    {
        while (Children.Count > 0)
            Children[0].SetParent(null);
    }

    public int GetSiblingIndex() => Parent?.Children.IndexOf(this) ?? 0;

    public void SetSiblingIndex(int index)
    {
        if (Parent is null)
            return;

        Parent.Children.Remove(this);
        Parent.Children.Insert(Mathf.Clamp(index, 0, Parent.Children.Count), this);
    }

    public void SetAsFirstSibling() => SetSiblingIndex(0);

    public void SetAsLastSibling() => SetSiblingIndex(int.MaxValue);

    public IEnumerator GetEnumerator()
    {
        Check();
        return Children.ToArray().GetEnumerator();
    }

    internal string GetPath() => Parent is null ? name : $"{Parent.GetPath()}/{name}";

    internal void Detach()
    {
        Parent?.Children.Remove(this);
        Parent = null;
    }
}
