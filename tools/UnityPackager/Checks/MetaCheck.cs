namespace NeuronMocap.UnityPackager.Checks;

/// <summary>Checks that every file and folder that Unity imports has a meta of the right kind, with a unique GUID. Other metas are errors.</summary>
internal static class MetaCheck
{
    public static IEnumerable<string> Check(StagedPackage package)
    {
        HashSet<string> folders = [.. package.AssetFolders];
        HashSet<string> assets = [.. package.AssetFiles, .. folders];
        Dictionary<string, string> owners = [];
        foreach (string path in assets.Order(StringComparer.Ordinal))
        {
            if (package.ReadMeta(path) is not { } meta)
            {
                yield return $"{path} has no meta: run dotnet run --project tools/UnityPackager -- --metas";
                continue;
            }

            if (MetaFile.FindGuid(meta) is not { } guid)
                yield return $"{path}.meta: no GUID";
            else if (!owners.TryAdd(guid, path))
                yield return $"{path}.meta: the GUID is that of {owners[guid]}";

            string expected = MetaFile.Create(path, folders.Contains(path), guid: string.Empty);
            if (MetaFile.FindImporter(meta) != MetaFile.FindImporter(expected))
                yield return $"{path}.meta: {MetaFile.FindImporter(meta) ?? "no importer"} instead of {MetaFile.FindImporter(expected)}";
            if (path.EndsWith(".dll", StringComparison.Ordinal) && MetaFile.FindGuid(meta) is { } id && meta != MetaFile.Create(path, isFolder: false, id))
                yield return $"{path}.meta: other settings than: enabled on every platform and in the editor, not explicitly referenced";
            if (meta.Contains("folderAsset: yes", StringComparison.Ordinal) != folders.Contains(path))
                yield return $"{path}.meta: describes a file as a folder, or a folder as a file";
            if (meta.Contains('\r', StringComparison.Ordinal))
                yield return $"{path}.meta: has Windows line ends";
        }

        foreach (IGrouping<string, string> same in assets.GroupBy(static path => path, StringComparer.OrdinalIgnoreCase).Where(static paths => paths.Count() > 1))
            yield return $"{string.Join(" and ", same.Order(StringComparer.Ordinal))}: one file on Windows and macOS";

        foreach (string meta in package.Files.Keys.Where(AssetPath.IsMeta).Where(meta => !assets.Contains(AssetPath.AssetOf(meta))))
            yield return $"{meta}: {AssetPath.AssetOf(meta)} does not exist or needs no meta";
    }
}
