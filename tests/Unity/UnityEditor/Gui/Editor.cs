using UnityEngine;

namespace UnityEditor;

public class Editor : ScriptableObject
{
    // An editor has its targets before OnEnable.
    private static UnityEngine.Object[] _next = [];

    public Editor()
    {
        targets = _next;
        serializedObject = new SerializedObject(targets);
    }

    public UnityEngine.Object target => targets[0];

    public UnityEngine.Object[] targets { get; }

    public SerializedObject serializedObject { get; }

    /// <summary>For tests: the number of requested repaints.</summary>
    public int Repaints { get; private set; }

    /// <summary>Creates the inspector of an object, found as in Unity: by [CustomEditor], or else the default one.</summary>
    public static Editor CreateEditor(UnityEngine.Object targetObject) => CreateEditor([targetObject]);

    public static Editor CreateEditor(UnityEngine.Object[] targetObjects)
    {
        Type inspected = targetObjects[0].GetType();
        Type type = AppDomain.CurrentDomain.GetAssemblies()
            .Where(static assembly => assembly.GetName().Name?.StartsWith("NeuronMocap.Unity", StringComparison.Ordinal) == true)
            .SelectMany(static assembly => assembly.GetTypes())
            .FirstOrDefault(type => type.GetCustomAttributes(typeof(CustomEditor), inherit: false).Cast<CustomEditor>().Any(mark => mark.Inspects(inspected)))
            ?? typeof(Editor);
        if (targetObjects.Length > 1 && type != typeof(Editor) && !type.IsDefined(typeof(CanEditMultipleObjects), inherit: false))
            throw new InvalidOperationException("Multi-object editing not supported.");

        _next = targetObjects;
        return (Editor)CreateInstance(type);
    }

    public virtual void OnInspectorGUI() => DrawDefaultInspector();

    public virtual bool RequiresConstantRepaint() => false;

    public bool DrawDefaultInspector()
    {
        serializedObject.Update();
        foreach (System.Reflection.FieldInfo field in SerializedFields.Of(target.GetType()).Where(static field => !field.IsDefined(typeof(HideInInspector), false)))
            EditorGUILayout.PropertyField(serializedObject.FindProperty(field.Name));

        return serializedObject.ApplyModifiedProperties();
    }

    public void Repaint() => Repaints++;
}
