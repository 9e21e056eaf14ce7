using System.Reflection;
using NeuronMocap.Tests.Infrastructure;
using NeuronMocap.UnityPackager;

namespace NeuronMocap.Packaging.Tests.Infrastructure;

/// <summary>The package of this repository, with the libraries that were built with the tests.</summary>
internal static class ThePackage
{
    private static readonly string Built = typeof(ThePackage).Assembly.GetCustomAttribute<AssemblyConfigurationAttribute>()!.Configuration;
    private static readonly Lazy<StagedPackage> Loaded = new(static () => StagedPackage.Load(new PackageFolder(Folder), Repository.Root, Built));

    public static string Folder => Repository.PathOf("unity-package");

    /// <summary>Debug or Release, as the tests.</summary>
    public static string Configuration => Built;

    public static StagedPackage Staged => Loaded.Value;

    /// <summary>A copy with something changed.</summary>
    public static StagedPackage With(Action<Dictionary<string, byte[]>> change)
    {
        Dictionary<string, byte[]> files = Staged.Files.ToDictionary(StringComparer.Ordinal);
        change(files);
        return new StagedPackage(files);
    }
}
