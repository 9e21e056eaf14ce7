using System.Reflection;
using System.Runtime.Versioning;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>The build of the libraries that the tests run with: the property LibraryFramework.</summary>
internal static class LibraryBuild
{
    public static string Framework { get; } = typeof(LibraryBuild).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>()
        .Single(static data => data.Key is "LibraryFramework").Value!;

    /// <summary>Returns whether an assembly is of that build.</summary>
    public static bool Holds(Assembly assembly) => string.Equals(Framework, FrameworkOf(assembly), StringComparison.Ordinal);

    /// <summary>Returns the framework that an assembly was built for, as a project names it.</summary>
    public static string FrameworkOf(Assembly assembly)
    {
        string[] parts = assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName.Split(["Version=v"], StringSplitOptions.None);
        return (parts[0] is ".NETStandard," ? "netstandard" : "net") + parts[1];
    }
}
