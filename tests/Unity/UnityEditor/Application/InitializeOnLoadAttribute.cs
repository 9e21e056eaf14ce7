namespace UnityEditor;

[AttributeUsage(AttributeTargets.Class)]
public sealed class InitializeOnLoadAttribute : Attribute;
