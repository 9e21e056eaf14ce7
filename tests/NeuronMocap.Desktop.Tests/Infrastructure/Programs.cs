using System.Reflection;

namespace NeuronMocap.Desktop.Tests.Infrastructure;

/// <summary>The programs under test, and the titles of their windows.</summary>
internal static class Programs
{
    public const string SampleTitle = "Motion";
    public const string WrapperTitle = "NeuronDataReader";

    private static readonly string Configuration = typeof(Programs).Assembly.GetCustomAttribute<AssemblyConfigurationAttribute>()!.Configuration;

    public static string Sample { get; } = Repository.PathOf("samples", "DesktopForms", "bin", Configuration, "net472", "DesktopForms.exe");

    public static string Wrapper { get; } =
        Repository.PathOf("tests", "NeuronMocap.Compatibility.Window", "bin", Configuration, "net472", "NeuronMocap.Compatibility.Window.exe");
}
