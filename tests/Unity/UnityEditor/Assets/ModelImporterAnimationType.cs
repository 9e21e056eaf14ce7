namespace UnityEditor;

public enum ModelImporterAnimationType
{
    None,
    Legacy,
    Generic,
    Human,
}
