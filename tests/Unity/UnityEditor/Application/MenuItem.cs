namespace UnityEditor;

[AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
public sealed class MenuItem(string itemName, bool isValidateFunction, int priority) : Attribute
{
    public MenuItem(string itemName)
        : this(itemName, false, 1000)
    {
    }

    public MenuItem(string itemName, bool isValidateFunction)
        : this(itemName, isValidateFunction, 1000)
    {
    }

    public string menuItem => itemName;

    public bool validate => isValidateFunction;

    public int priority { get; set; } = priority;
}
