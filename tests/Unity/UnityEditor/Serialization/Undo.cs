using System.Reflection;
using UnityEngine;

namespace UnityEditor;

/// <summary>Keeps previous states in groups. PerformUndo restores the newest group.</summary>
public static class Undo
{
    private static readonly List<(int Group, string Name, Action Back)> Steps = [];
    private static int _group;
    private static string _groupName = "";

    public delegate void UndoRedoCallback();

    // A field in Unity, with the same usage.
    public static event UndoRedoCallback? undoRedoPerformed;

    /// <summary>For tests: the names of the steps that can be undone, the oldest first.</summary>
    public static IReadOnlyList<string> Names => [.. Steps.Select(static step => step.Name)];

    public static int GetCurrentGroup() => _group;

    public static void SetCurrentGroupName(string name) => _groupName = name;

    public static string GetCurrentGroupName() => _groupName;

    // In the editor, every event of the user starts a new group.
    public static void IncrementCurrentGroup() => _group++;

    public static void CollapseUndoOperations(int groupIndex)
    {
        for (int i = 0; i < Steps.Count; i++)
        {
            if (Steps[i].Group > groupIndex)
                Steps[i] = (groupIndex, Steps[i].Name, Steps[i].Back);
        }
    }

    public static void RecordObject(UnityEngine.Object objectToUndo, string name) => RecordObjects([objectToUndo], name);

    public static void RecordObjects(UnityEngine.Object[] objectsToUndo, string name)
    {
        foreach (UnityEngine.Object item in objectsToUndo)
            Steps.Add((_group, name, Remember(item)));
    }

    public static void RegisterCompleteObjectUndo(UnityEngine.Object objectToUndo, string name) => RecordObject(objectToUndo, name);

    public static void RegisterFullObjectHierarchyUndo(UnityEngine.Object objectToUndo, string name)
    {
        GameObject root = objectToUndo as GameObject ?? ((Component)objectToUndo).gameObject;
        RecordObjects([.. root.GetComponentsInChildren<Transform>(true)], name);
    }

    public static void RegisterCreatedObjectUndo(UnityEngine.Object objectToUndo, string name) =>
        Steps.Add((_group, name, () => UnityEngine.Object.DestroyImmediate(objectToUndo)));

    /// <summary>Destroys a component. Undo brings back the same object.</summary>
    public static void DestroyObjectImmediate(UnityEngine.Object objectToUndo)
    {
        var component = (Component)objectToUndo;
        GameObject owner = component.gameObject;
        int index = owner.Components.IndexOf(component);
        UnityEngine.Object.DestroyImmediate(component, true);
        if (!component.IsDestroyed)
            return;

        Steps.Add((_group, "Destroy Object", Restore));

        void Restore()
        {
            UnityEngine.StandIn.World.Restore(component);
            owner.Components.Insert(index, component);
        }
    }

    public static T AddComponent<T>(GameObject gameObject)
        where T : Component
    {
        T added = gameObject.AddComponent<T>();
        RegisterCreatedObjectUndo(added, $"Add {typeof(T).Name}");
        return added;
    }

    public static void PerformUndo()
    {
        if (Steps.Count == 0)
            return;

        int newest = Steps.Max(static step => step.Group);
        for (int i = Steps.Count - 1; i >= 0; i--)
        {
            if (Steps[i].Group != newest)
                continue;

            Action back = Steps[i].Back;
            Steps.RemoveAt(i);
            back();
        }

        undoRedoPerformed?.Invoke();
    }

    public static void ClearAll()
    {
        Steps.Clear();
        _group = 0;
    }

    private static Action Remember(UnityEngine.Object item)
    {
        if (item is Transform transform)
        {
            (Vector3 position, Quaternion rotation, Vector3 scale) = (transform.localPosition, transform.localRotation, transform.localScale);
            return () =>
            {
                transform.localPosition = position;
                transform.localRotation = rotation;
                transform.localScale = scale;
            };
        }

        IReadOnlyList<string> missing = (item as GameObject)?.MissingScripts ?? [];
        (FieldInfo Field, object? Value)[] fields = [.. SerializedFields.Of(item.GetType()).Select(field => (field, Copy(field, field.GetValue(item))))];

        // Engine types keep their state behind properties.
        (PropertyInfo Property, object? Value)[] properties = item.GetType().Assembly != typeof(UnityEngine.Object).Assembly
            ? []
            : [.. item.GetType().GetProperties(BindingFlags.Instance | BindingFlags.Public | BindingFlags.DeclaredOnly)
                .Where(static property => property.CanRead && property.SetMethod?.IsPublic == true && property.GetIndexParameters().Length == 0)
                .Select(property => (property, property.GetValue(item)))];
        return () =>
        {
            foreach ((FieldInfo field, object? value) in fields)
                field.SetValue(item, Copy(field, value));
            foreach ((PropertyInfo property, object? value) in properties)
                property.SetValue(item, value);
            if (item is GameObject owner)
                owner.MissingScripts = missing;
        };
    }

    // With the objects that are part of it, as they are serialised.
    private static object? Copy(FieldInfo field, object? value) => UnityEngine.StandIn.Serialization.Copy(value, field.FieldType, static item => item);
}
