namespace UnityEditor;

[AttributeUsage(AttributeTargets.Method)]
public sealed class SettingsProviderAttribute : Attribute;
