using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace NeuronMocap.Packaging.Tests.Infrastructure;

/// <summary>What a project of ASP.NET Core with a reference to NeuronMocap makes of a program.</summary>
internal static class ServerCompiler
{
    // The usings that such a project has by itself, those that the programs need.
    private const string ImplicitUsings = """
        global using System;
        global using System.Threading;
        global using System.Threading.Tasks;
        global using Microsoft.AspNetCore.Builder;
        global using Microsoft.AspNetCore.Http;
        """;

    // With the frameworks come the assemblies of this project, NeuronMocap among them.
    private static readonly MetadataReference[] References = [.. ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!)
        .Split(Path.PathSeparator)
        .Select(static file => MetadataReference.CreateFromFile(file))];

    public static IEnumerable<Diagnostic> FindErrors(string program) => CSharpCompilation
        .Create(
            "Server",
            [CSharpSyntaxTree.ParseText(ImplicitUsings), CSharpSyntaxTree.ParseText(program)],
            References,
            new CSharpCompilationOptions(OutputKind.ConsoleApplication, nullableContextOptions: NullableContextOptions.Enable))
        .GetDiagnostics(TestContext.Current.CancellationToken)
        .Where(static problem => problem.Severity == DiagnosticSeverity.Error);
}
