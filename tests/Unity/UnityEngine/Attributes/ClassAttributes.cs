#pragma warning disable CA1813, CA1019, CA1051 // Public fields, and not sealed: as Unity's are.
namespace UnityEngine;

[AttributeUsage(AttributeTargets.Class)]
public sealed class AddComponentMenu(string menuName, int order) : Attribute
{
    public AddComponentMenu(string menuName)
        : this(menuName, 0)
    {
    }

    public string componentMenu { get; } = menuName;

    public int componentOrder { get; } = order;
}

[AttributeUsage(AttributeTargets.Class)]
public class DefaultExecutionOrder(int order) : Attribute
{
    public int order { get; } = order;
}

[AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
public sealed class RequireComponent(Type requiredComponent) : Attribute
{
    public Type m_Type0 = requiredComponent;
    public Type? m_Type1;
    public Type? m_Type2;

    public RequireComponent(Type requiredComponent, Type requiredComponent2)
        : this(requiredComponent) => m_Type1 = requiredComponent2;

    public RequireComponent(Type requiredComponent, Type requiredComponent2, Type requiredComponent3)
        : this(requiredComponent, requiredComponent2) => m_Type2 = requiredComponent3;
}

[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public sealed class DisallowMultipleComponent : Attribute
{
}

[AttributeUsage(AttributeTargets.Class)]
public sealed class ExecuteAlways : Attribute
{
}

[AttributeUsage(AttributeTargets.Class)]
public sealed class ExecuteInEditMode : Attribute
{
}

[AttributeUsage(AttributeTargets.Class)]
public sealed class SelectionBaseAttribute : Attribute
{
}

[AttributeUsage(AttributeTargets.Class, AllowMultiple = false)]
public sealed class HelpURLAttribute(string url) : Attribute
{
    public string URL { get; } = url;
}

[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public sealed class CreateAssetMenuAttribute : Attribute
{
    public string? menuName { get; set; }

    public string? fileName { get; set; }

    public int order { get; set; }
}

[AttributeUsage(AttributeTargets.Class)]
public sealed class IconAttribute(string path) : Attribute
{
    public string path { get; } = path;
}
