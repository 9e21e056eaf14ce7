namespace Unity.LiveCapture;

[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public sealed class CreateDeviceMenuItemAttribute(string itemName, int priority = 0) : Attribute
{
    public string itemName { get; } = itemName;

    public int priority { get; } = priority;
}
