using System.Reflection;
using NeuronMocap.Tests.Infrastructure;
using NeuronMocap.UnityPackager;
using NeuronMocap.UnityPackager.Archives;

namespace NeuronMocap.Packaging.Tests.Infrastructure;

/// <summary>The package of this repository, with the libraries built with the tests.</summary>
internal static class ThePackage
{
    private static readonly string Built = typeof(ThePackage).Assembly.GetCustomAttribute<AssemblyConfigurationAttribute>()!.Configuration;
    private static readonly Lazy<StagedPackage> Loaded = new(static () => StagedPackage.Load(new PackageFolder(Folder), Repository.Root, Built));
    private static readonly Lazy<byte[]> PackedTarball = new(static () => UpmTarball.Create(Staged));
    private static readonly Lazy<byte[]> PackedAssets = new(static () => UnityPackageArchive.Create(Staged));

    public static string Folder => Repository.PathOf("unity-package");

    /// <summary>Debug or Release, like the tests.</summary>
    public static string Configuration => Built;

    public static StagedPackage Staged => Loaded.Value;

    /// <summary>The archive for the package manager.</summary>
    public static byte[] Tarball => PackedTarball.Value;

    /// <summary>The archive that Unity imports.</summary>
    public static byte[] AssetPackage => PackedAssets.Value;

    /// <summary>Returns a changed copy.</summary>
    public static StagedPackage With(Action<Dictionary<string, byte[]>> change)
    {
        Dictionary<string, byte[]> files = Staged.Files.ToDictionary(StringComparer.Ordinal);
        change(files);
        return new StagedPackage(files);
    }
}
