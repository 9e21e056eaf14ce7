namespace NeuronMocap.Desktop.Tests.Infrastructure;

/// <summary>The programs under test, and the titles of their windows.</summary>
internal static class Programs
{
    public const string SampleTitle = "Motion";
    public const string WrapperTitle = "NeuronDataReader";

    public static string Sample { get; } = Repository.PathOf("samples", "DesktopForms", "bin", "Debug", "net472", "DesktopForms.exe");

    public static string Wrapper { get; } =
        Repository.PathOf("tests", "NeuronMocap.Compatibility.Window", "bin", "Debug", "net472", "NeuronMocap.Compatibility.Window.exe");
}
