namespace UnityEditor;

[AttributeUsage(AttributeTargets.Class)]
public sealed class FilePathAttribute(string relativePath, FilePathAttribute.Location location) : Attribute
{
    internal string RelativePath => relativePath;

    internal Location Place => location;

    public enum Location
    {
        PreferencesFolder,
        ProjectFolder,
    }
}
