namespace UnityEditor;

[AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
public sealed class CustomEditor(Type inspectedType, bool editorForChildClasses) : Attribute
{
    public CustomEditor(Type inspectedType)
        : this(inspectedType, false)
    {
    }

    internal bool Inspects(Type type) => editorForChildClasses ? inspectedType.IsAssignableFrom(type) : inspectedType == type;
}
