namespace NeuronMocap.UnityPackager.Checks;

/// <summary>Finds all faults of a package and describes where they are.</summary>
internal static class PackageLint
{
    public static IReadOnlyList<string> Check(StagedPackage package)
    {
        // Without a manifest, other checks are useless: the version of the libraries cannot be compared with anything.
        if (ManifestCheck.FindUnreadable(package) is { } unreadable)
            return [unreadable];

        return
        [
            .. MetaCheck.Check(package),
            .. ManifestCheck.Check(package),
            .. AssemblyDefinitionCheck.Check(package),
            .. SourceCheck.Check(package),
            .. LibraryCheck.Check(package),
            .. SceneCheck.Check(package),
        ];
    }
}
