using System.Reflection;
using UnityEngine;

namespace UnityEditor;

/// <summary>A copy of the serialised fields of one or several objects. It writes changes back, with Undo.</summary>
public sealed class SerializedObject : IDisposable
{
    private readonly Dictionary<string, SerializedProperty> _properties = [];

    public SerializedObject(UnityEngine.Object obj)
        : this([obj])
    {
    }

    public SerializedObject(UnityEngine.Object[] objs)
    {
        if (objs.Length == 0 || objs.Any(static item => item == null))
            throw new ArgumentException("Object at index 0 is null", nameof(objs));

        targetObjects = objs;
    }

    public UnityEngine.Object targetObject => targetObjects[0];

    public UnityEngine.Object[] targetObjects { get; }

    public bool isEditingMultipleObjects => targetObjects.Length > 1;

    public bool hasModifiedProperties => _properties.Values.Any(static property => property.IsModified);

    public void Update()
    {
        foreach (SerializedProperty property in _properties.Values)
            property.Read();
    }

    public SerializedProperty FindProperty(string propertyPath)
    {
        if (_properties.TryGetValue(propertyPath, out SerializedProperty? known))
            return known;

        // Null if the field does not exist, as in Unity, although the signature does not say so.
        FieldInfo? field = SerializedFields.Find(targetObject.GetType(), propertyPath);
        if (field is null)
            return null!;

        var property = new SerializedProperty(this, field);
        _properties.Add(propertyPath, property);
        return property;
    }

    public SerializedProperty GetIterator() => new(this, [.. SerializedFields.Of(targetObject.GetType())
        .Where(static field => !field.IsDefined(typeof(HideInInspector), inherit: false))
        .Select(field => FindProperty(field.Name))]);

    public bool ApplyModifiedProperties()
    {
        if (hasModifiedProperties)
            Undo.RecordObjects(targetObjects, $"Modified Property in {targetObject.name}");

        return ApplyModifiedPropertiesWithoutUndo();
    }

    public bool ApplyModifiedPropertiesWithoutUndo()
    {
        if (!hasModifiedProperties)
            return false;

        foreach (SerializedProperty property in _properties.Values)
            property.Write();

        foreach (UnityEngine.Object target in targetObjects)
            SerializedFields.CallOnValidate(target);

        return true;
    }

    public void Dispose()
    {
    }
}
