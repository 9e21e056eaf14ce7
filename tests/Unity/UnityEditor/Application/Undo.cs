namespace UnityEditor;

public class Undo
{
    public delegate void UndoRedoCallback();

    private static readonly List<string> _steps = [];

    public static UndoRedoCallback? undoRedoPerformed;

    /// <summary>What could be undone, newest last.</summary>
    internal static IReadOnlyList<string> Steps => _steps;

    public static void RecordObject(Object objectToUndo, string name) => _steps.Add(name);

    public static void RecordObjects(Object[] objectsToUndo, string name) => _steps.Add(name);

    public static void RegisterCompleteObjectUndo(Object objectToUndo, string name) => _steps.Add(name);

    public static void RegisterFullObjectHierarchyUndo(Object objectToUndo, string name) => _steps.Add(name);

    public static void RegisterCreatedObjectUndo(Object objectToUndo, string name) => _steps.Add(name);

    public static void DestroyObjectImmediate(Object objectToUndo)
    {
        _steps.Add("Destroy");
        Object.DestroyImmediate(objectToUndo);
    }

    public static T AddComponent<T>(GameObject gameObject)
        where T : Component => (T)AddComponent(gameObject, typeof(T));

    public static Component AddComponent(GameObject gameObject, Type type)
    {
        _steps.Add($"Add {type.Name}");
        return gameObject.AddComponent(type);
    }

    public static void SetTransformParent(Transform transform, Transform? newParent, string name)
    {
        _steps.Add(name);
        transform.SetParent(newParent);
    }

    public static void SetCurrentGroupName(string name)
    {
    }

    public static int GetCurrentGroup() => 0;

    public static void CollapseUndoOperations(int groupIndex)
    {
    }

    public static void IncrementCurrentGroup()
    {
    }

    internal static void Forget()
    {
        undoRedoPerformed = null;
        _steps.Clear();
    }
}
