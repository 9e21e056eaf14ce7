#pragma warning disable CA1813, CA1019, CA1051 // Public read-only fields, and not sealed: as Unity's are.
namespace UnityEngine;

[AttributeUsage(AttributeTargets.Field)]
public sealed class SerializeField : Attribute
{
}

[AttributeUsage(AttributeTargets.Field)]
public sealed class SerializeReference : Attribute
{
}

[AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = false)]
public abstract class PropertyAttribute : Attribute
{
    public int order { get; set; }
}

[AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = false)]
public class TooltipAttribute(string tooltip) : PropertyAttribute
{
    public readonly string tooltip = tooltip;
}

[AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = false)]
public sealed class RangeAttribute(float min, float max) : PropertyAttribute
{
    public readonly float min = min;
    public readonly float max = max;
}

[AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = false)]
public sealed class MinAttribute(float min) : PropertyAttribute
{
    public readonly float min = min;
}

[AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = true)]
public class HeaderAttribute(string header) : PropertyAttribute
{
    public readonly string header = header;
}

[AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = true)]
public class SpaceAttribute(float height) : PropertyAttribute
{
    public readonly float height = height;

    public SpaceAttribute()
        : this(8)
    {
    }
}

[AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = false)]
public sealed class TextAreaAttribute(int minLines, int maxLines) : PropertyAttribute
{
    public readonly int minLines = minLines;
    public readonly int maxLines = maxLines;

    public TextAreaAttribute()
        : this(3, 3)
    {
    }
}

[AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = false)]
public sealed class MultilineAttribute(int lines) : PropertyAttribute
{
    public readonly int lines = lines;

    public MultilineAttribute()
        : this(3)
    {
    }
}

[AttributeUsage(AttributeTargets.Field)]
public sealed class HideInInspector : Attribute
{
}

[AttributeUsage(AttributeTargets.Field | AttributeTargets.Enum)]
public class InspectorNameAttribute(string displayName) : PropertyAttribute
{
    public readonly string displayName = displayName;
}

[AttributeUsage(AttributeTargets.Field, AllowMultiple = false)]
public class ContextMenuItemAttribute(string name, string function) : PropertyAttribute
{
    public readonly string name = name;
    public readonly string function = function;
}
