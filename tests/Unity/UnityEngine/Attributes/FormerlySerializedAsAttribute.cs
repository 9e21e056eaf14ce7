namespace UnityEngine.Serialization;

[AttributeUsage(AttributeTargets.Field, AllowMultiple = true, Inherited = false)]
public class FormerlySerializedAsAttribute(string oldName) : Attribute
{
    public string oldName { get; } = oldName;
}
