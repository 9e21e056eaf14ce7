namespace NeuronMocap.Tests.Infrastructure;

// Recordings and byte streams that are not part of the repository, in the folder shared/data beside it, if that exists.
internal static class Fixtures
{
    public static string Folder { get; } = Path.GetFullPath(Path.Combine(Repository.Root, "..", "shared", "data"));

    public static bool Exists => Directory.Exists(Folder);

    public static string Require(params string[] parts)
    {
        string path = Path.Combine([Folder, .. parts]);
        Assert.SkipUnless(File.Exists(path), $"shared/data/{string.Join('/', parts)} is not beside the repository.");
        return path;
    }
}
