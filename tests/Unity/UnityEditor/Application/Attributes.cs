#pragma warning disable CA1813, CA1019, CA1051 // Public fields, and not sealed: as Unity's are.
namespace UnityEditor;

[AttributeUsage(AttributeTargets.Class)]
public class InitializeOnLoadAttribute : Attribute
{
}

[AttributeUsage(AttributeTargets.Method)]
public class InitializeOnLoadMethodAttribute : Attribute
{
}

[AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
public sealed class MenuItem(string itemName, bool isValidateFunction, int priority) : Attribute
{
    public string menuItem = itemName;
    public bool validate = isValidateFunction;
    public int priority = priority;

    public MenuItem(string itemName)
        : this(itemName, false)
    {
    }

    public MenuItem(string itemName, bool isValidateFunction)
        : this(itemName, isValidateFunction, 1000)
    {
    }
}

[AttributeUsage(AttributeTargets.Class, AllowMultiple = true, Inherited = false)]
public class CustomEditor(Type inspectedType, bool editorForChildClasses) : Attribute
{
    public CustomEditor(Type inspectedType)
        : this(inspectedType, false)
    {
    }

    public bool isFallback { get; set; }

    internal Type InspectedType { get; } = inspectedType;

    internal bool ForChildren { get; } = editorForChildClasses;
}

[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public sealed class CanEditMultipleObjects : Attribute
{
}

[AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
public sealed class CustomPropertyDrawer(Type type, bool useForChildren) : Attribute
{
    public CustomPropertyDrawer(Type type)
        : this(type, false)
    {
    }

    internal Type Type { get; } = type;

    internal bool UseForChildren { get; } = useForChildren;
}

[AttributeUsage(AttributeTargets.Method)]
public sealed class DrawGizmo(GizmoType gizmo, Type? drawnGizmoType) : Attribute
{
    public Type? drawnType = drawnGizmoType;
    public GizmoType drawOptions = gizmo;

    public DrawGizmo(GizmoType gizmo)
        : this(gizmo, null)
    {
    }
}

[Flags]
public enum GizmoType
{
    Pickable = 1,
    NotInSelectionHierarchy = 2,
    NonSelected = 32,
    Selected = 4,
    Active = 8,
    InSelectionHierarchy = 16,
}
