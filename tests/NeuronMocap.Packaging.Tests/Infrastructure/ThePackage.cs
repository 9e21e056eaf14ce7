using System.Reflection;
using NeuronMocap.Tests.Infrastructure;
using NeuronMocap.UnityPackager;

namespace NeuronMocap.Packaging.Tests.Infrastructure;

/// <summary>The package of this repository, with the libraries built with the tests.</summary>
internal static class ThePackage
{
    private static readonly string Built = typeof(ThePackage).Assembly.GetCustomAttribute<AssemblyConfigurationAttribute>()!.Configuration;
    private static readonly Lazy<StagedPackage> Loaded = new(static () => StagedPackage.Load(new PackageFolder(Folder), Repository.Root, Built));

    public static string Folder => Repository.PathOf("unity-package");

    /// <summary>Debug or Release, like the tests.</summary>
    public static string Configuration => Built;

    public static StagedPackage Staged => Loaded.Value;

    /// <summary>Returns a changed copy.</summary>
    public static StagedPackage With(Action<Dictionary<string, byte[]>> change)
    {
        Dictionary<string, byte[]> files = Staged.Files.ToDictionary(StringComparer.Ordinal);
        change(files);
        return new StagedPackage(files);
    }
}
