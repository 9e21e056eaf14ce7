#pragma warning disable CA1813, CA1019 // Not sealed: as Unity's are.
namespace UnityEngine;

[AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
public sealed class ContextMenu(string itemName, bool isValidateFunction, int priority) : Attribute
{
    public readonly string menuItem = itemName;
    public readonly bool validate = isValidateFunction;
    public readonly int priority = priority;

    public ContextMenu(string itemName)
        : this(itemName, false)
    {
    }

    public ContextMenu(string itemName, bool isValidateFunction)
        : this(itemName, isValidateFunction, 1_000_000)
    {
    }
}

public enum RuntimeInitializeLoadType
{
    AfterSceneLoad,
    BeforeSceneLoad,
    AfterAssembliesLoaded,
    BeforeSplashScreen,
    SubsystemRegistration,
}

[AttributeUsage(AttributeTargets.Method, AllowMultiple = false)]
public class RuntimeInitializeOnLoadMethodAttribute(RuntimeInitializeLoadType loadType) : Scripting.PreserveAttribute
{
    public RuntimeInitializeOnLoadMethodAttribute()
        : this(RuntimeInitializeLoadType.AfterSceneLoad)
    {
    }

    public RuntimeInitializeLoadType loadType { get; } = loadType;
}
