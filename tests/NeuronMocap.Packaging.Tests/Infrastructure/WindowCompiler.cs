using System.Reflection;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using NeuronMocap.Tests.Infrastructure;

namespace NeuronMocap.Packaging.Tests.Infrastructure;

/// <summary>Compiles a part of a window of .NET Framework, with what the designer or the XAML of the window adds.</summary>
internal static class WindowCompiler
{
    private const string Usings = """
        global using System;
        global using System.Windows;
        global using System.Windows.Threading;
        global using NeuronMocap;
        global using NeuronMocap.Skeleton;
        """;

    private const string WindowsForms = """
        global using System.Windows.Forms;

        partial class MainForm
        {
            private readonly Label statusLabel = new();
            private readonly Control figure = new();

            private void InitializeComponent()
            {
            }
        }
        """;

    // The page leaves out the class around its constructor.
    private const string Wpf = """
        partial class MainWindow : Window
        {
            private readonly NeuronReader _reader = new("127.0.0.1");
            private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];
            private readonly FrameworkElement figure = new();

            private void InitializeComponent()
            {
            }
        """;

    private static readonly string[] FrameworkFiles =
    [
        "mscorlib", "System", "System.Core", "System.Drawing", "System.Numerics", "System.Windows.Forms", "System.Xaml", "PresentationCore",
        "PresentationFramework", "WindowsBase", "Facades/netstandard", "Facades/System.Runtime", "Facades/System.ObjectModel",
    ];

    private static readonly string Framework = typeof(WindowCompiler).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>()
        .Single(static entry => entry.Key == "NetFramework").Value!;

    // The sample's folder has the libraries for .NET Framework and what they need.
    private static readonly MetadataReference[] References =
    [
        .. FrameworkFiles.Select(static name => MetadataReference.CreateFromFile(Path.Combine(Framework, $"{name}.dll"))),
        .. Directory.GetFiles(Repository.PathOf("samples", "DesktopForms", "bin", ThePackage.Configuration, "net472"), "*.dll")
            .Select(static file => MetadataReference.CreateFromFile(file)),
    ];

    /// <param name="framework">What a page names in its marker "needs": Windows Forms or WPF.</param>
    /// <param name="code">The code of the page.</param>
    public static IEnumerable<Diagnostic> FindErrors(string framework, string code) => framework == "WPF"
        ? Compile($"{Wpf}\n{code}\n}}")
        : Compile(WindowsForms, code);

    private static IEnumerable<Diagnostic> Compile(params string[] sources) => CSharpCompilation
        .Create(
            "Window",
            [CSharpSyntaxTree.ParseText(Usings), .. sources.Select(static source => CSharpSyntaxTree.ParseText(source))],
            References,
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, nullableContextOptions: NullableContextOptions.Enable))
        .GetDiagnostics(TestContext.Current.CancellationToken)
        .Where(static problem => problem.Severity == DiagnosticSeverity.Error);
}
