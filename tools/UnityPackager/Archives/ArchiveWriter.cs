namespace NeuronMocap.UnityPackager.Archives;

/// <summary>Writes both archives, and reads them again to check them.</summary>
internal static class ArchiveWriter
{
    /// <exception cref="PackagerException">An archive does not contain exactly the expected files.</exception>
    public static void Write(StagedPackage package, string folder)
    {
        Directory.CreateDirectory(folder);
        string tarball = Write(Path.Combine(folder, UpmTarball.NameOf(package)), UpmTarball.Create(package));
        Compare(package.Files, UpmTarball.Read(File.ReadAllBytes(tarball)).Files, tarball);
        string assets = Write(Path.Combine(folder, UnityPackageArchive.NameOf(package)), UnityPackageArchive.Create(package));
        Compare(UnityPackageArchive.FilesOf(package), UnityPackageArchive.Read(File.ReadAllBytes(assets)), assets);
    }

    private static string Write(string path, byte[] archive)
    {
        File.WriteAllBytes(path, archive);
        Console.WriteLine(path);
        return path;
    }

    private static void Compare(IReadOnlyDictionary<string, byte[]> expected, IReadOnlyDictionary<string, byte[]> actual, string archive)
    {
        if (expected.Keys.Union(actual.Keys).FirstOrDefault(path => !AreEqual(path, expected, actual)) is { } different)
            throw new PackagerException($"{archive}: {different} is missing, unexpected or changed.");
    }

    private static bool AreEqual(string path, IReadOnlyDictionary<string, byte[]> expected, IReadOnlyDictionary<string, byte[]> actual) =>
        expected.TryGetValue(path, out byte[]? first) && actual.TryGetValue(path, out byte[]? second) && first.AsSpan().SequenceEqual(second);
}
