using System.Text.RegularExpressions;
using NeuronMocap.Packaging.Tests.Infrastructure;

namespace NeuronMocap.Packaging.Tests.Documentation;

// The scripts on the pages are compiled unchanged. The marker <!-- program: SDK --> precedes the program of a server.
public sealed partial class ExampleTests
{
    private static readonly UnityCompiler Compiler = new(ThePackage.Staged, isEditor: false);

    public static TheoryData<string, string> Scripts => Find(isProgram: false);

    public static TheoryData<string, string> Programs => Find(isProgram: true);

    [Theory]
    [MemberData(nameof(Scripts))]
    public void An_example_compiles_with_the_package(string page, string code) =>
        Assert.Empty(Compiler.FindErrors(code).Select(problem => $"{page}: {problem}"));

    [Theory]
    [MemberData(nameof(Programs))]
    public void A_server_example_compiles(string page, string code) =>
        Assert.Empty(ServerCompiler.FindErrors(code).Select(problem => $"{page}: {problem}"));

    [Fact]
    public void A_server_example_with_an_unknown_name_does_not_compile() =>
        Assert.NotEmpty(ServerCompiler.FindErrors("var reader = new NeuronMocap.NeuronReeder();"));

    [Fact]
    public void An_example_with_an_unknown_name_does_not_compile() =>
        Assert.NotEmpty(Compiler.FindErrors("class Example { NeuronMocap.Unity.MocapSauce source; }"));

    private static TheoryData<string, string> Find(bool isProgram)
    {
        TheoryData<string, string> examples = [];
        foreach (string page in Directory.EnumerateFiles(ThePackage.Folder, "*.md", SearchOption.AllDirectories).Order(StringComparer.Ordinal))
        {
            foreach (Match block in Block().Matches(File.ReadAllText(page)).Where(block => block.Groups["program"].Success == isProgram))
                examples.Add(Path.GetRelativePath(ThePackage.Folder, page), block.Groups["code"].Value);
        }

        return examples;
    }

    [GeneratedRegex("^(?<program><!-- program: [^\n]* -->\n)?```csharp\n(?<code>.*?)^```", RegexOptions.Multiline | RegexOptions.Singleline | RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Block();
}
