using System.Reflection;
using System.Runtime.Versioning;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>The build of the libraries that the tests run with: the property LibraryFramework.</summary>
internal static class LibraryBuild
{
    public static bool IsNetStandard { get; } = typeof(LibraryBuild).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>()
        .Single(static data => data.Key is "LibraryFramework").Value is "netstandard2.1";

    /// <summary>Returns whether an assembly is of that build.</summary>
    public static bool Holds(Assembly assembly) =>
        IsNetStandard == assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName.StartsWith(".NETStandard", StringComparison.Ordinal);
}
