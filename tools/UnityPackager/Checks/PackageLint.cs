namespace NeuronMocap.UnityPackager.Checks;

/// <summary>Everything that is wrong with a package, in words that say where.</summary>
internal static class PackageLint
{
    public static IReadOnlyList<string> Check(StagedPackage package)
    {
        // All else is of no use, and the version of the libraries has nothing to be compared with.
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
