#pragma warning disable CA1813, CA1019, CA1051 // Public fields, and not sealed: as Unity's are.
namespace UnityEditor;

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
