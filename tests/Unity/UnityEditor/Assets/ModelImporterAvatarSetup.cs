namespace UnityEditor;

public enum ModelImporterAvatarSetup
{
    NoAvatar,
    CreateFromThisModel,
    CopyFromOther,
}
