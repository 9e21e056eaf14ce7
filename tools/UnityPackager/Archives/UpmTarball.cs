namespace NeuronMocap.UnityPackager.Archives;

/// <summary>The package for Unity's package manager and npm: a tarball with all files under package/.</summary>
internal static class UpmTarball
{
    private const string Root = "package/";

    public static string NameOf(StagedPackage package) => $"{package.Name}-{package.Version}.tgz";

    public static byte[] Create(StagedPackage package) =>
        TarGz.Create(package.Files.Select(static file => (Root + file.Key, (byte[]?)file.Value)));

    /// <exception cref="PackagerException">A file is not where npm expects it.</exception>
    public static StagedPackage Read(byte[] archive) => new(TarGz.Read(archive).Select(static file => file.Key.StartsWith(Root, StringComparison.Ordinal)
        ? KeyValuePair.Create(file.Key[Root.Length..], file.Value)
        : throw new PackagerException($"{file.Key} is not under {Root}")));
}
