namespace UnityEngine;

[AttributeUsage(AttributeTargets.Field)]
public sealed class DelayedAttribute : PropertyAttribute
{
}
