using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using NeuronMocap.Tests.Infrastructure;

namespace NeuronMocap.Packaging.Tests.Infrastructure;

/// <summary>
/// Compiles a program as an ASP.NET Core project with references to NeuronMocap, NeuronMocap.Server, NeuronMocap.AspNetCore and NeuronMocap.RabbitMq does.
/// </summary>
internal static class ServerCompiler
{
    // The implicit usings of such a project that the programs need.
    private const string ImplicitUsings = """
        global using System;
        global using System.Threading;
        global using System.Threading.Tasks;
        global using Microsoft.AspNetCore.Builder;
        global using Microsoft.AspNetCore.Hosting;
        global using Microsoft.AspNetCore.Http;
        """;

    // The frameworks' assemblies include those of this project, and thus NeuronMocap.
    private static readonly MetadataReference[] References = [.. ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!)
        .Split(Path.PathSeparator)
        .Append(Repository.PathOf("src", "NeuronMocap.AspNetCore", "bin", ThePackage.Configuration, "net8.0", "NeuronMocap.AspNetCore.dll"))
        .Append(Repository.PathOf("src", "NeuronMocap.Server", "bin", ThePackage.Configuration, "netstandard2.1", "NeuronMocap.Server.dll"))
        .Append(Repository.PathOf("src", "NeuronMocap.RabbitMq", "bin", ThePackage.Configuration, "netstandard2.1", "NeuronMocap.RabbitMq.dll"))
        .Select(static file => MetadataReference.CreateFromFile(file))];

    private static readonly CSharpCompilation Project = CSharpCompilation.Create(
        "Server",
        [CSharpSyntaxTree.ParseText(ImplicitUsings)],
        References,
        new CSharpCompilationOptions(OutputKind.ConsoleApplication, nullableContextOptions: NullableContextOptions.Enable));

    public static IEnumerable<Diagnostic> FindErrors(string program) => Project
        .AddSyntaxTrees(CSharpSyntaxTree.ParseText(program))
        .GetDiagnostics(TestContext.Current.CancellationToken)
        .Where(static problem => problem.Severity == DiagnosticSeverity.Error);
}
