using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;
using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.Tests.Infrastructure;

namespace NeuronMocap.Packaging.Tests.Documentation;

/// <summary>Parts of programs on the pages: they compile, and name the namespaces they need. CI runs the whole programs, which have a marker.</summary>
public sealed partial class SnippetTests
{
    private const string UnknownName = "CS0103";

    // What the reader of a page puts in.
    private static readonly HashSet<string> Placeholders =
    [
        "reader", "builder", "running", "avatar", "actor", "rig", "retargeter", "pose", "localPose", "world", "body", "seconds",
        "Apply", "Draw", "Render", "Text",
    ];

    public static TheoryData<string, string> Snippets
    {
        get
        {
            TheoryData<string, string> snippets = [];
            foreach (string page in Directory.GetFiles(Repository.PathOf("docs"), "*.md", SearchOption.AllDirectories).Order(StringComparer.Ordinal))
            {
                // Those for the vendor's functions need another library, and those with the marker "needs" a framework that is not here.
                foreach (Match block in Block().Matches(File.ReadAllText(page)).Where(static block => !block.Groups["marker"].Success && !block.Value.Contains("NeuronDataReader.", StringComparison.Ordinal)))
                    snippets.Add(Path.GetFileName(page), block.Groups["code"].Value);
            }

            return snippets;
        }
    }

    [Theory, MemberData(nameof(Snippets))]
    public void A_snippet_compiles_but_for_its_placeholders(string page, string code)
    {
        IEnumerable<Diagnostic> errors = ServerCompiler.FindErrors(code).Where(static error => error.Id != UnknownName || !Placeholders.Contains(Quoted().Match(error.GetMessage()).Value));
        Assert.Empty(errors.Select(error => $"{page}: {error}"));
    }

    [Theory]
    [InlineData("Windows Forms")]
    [InlineData("WPF")]
    public void A_window_of_the_guide_compiles(string framework)
    {
        string code = CodeOfWindow(framework);
        Assert.Empty(WindowCompiler.FindErrors(framework, code));
        Assert.NotEmpty(WindowCompiler.FindErrors(framework, code.Replace("_reader.Start()", "_reader.Begin()", StringComparison.Ordinal)));
    }

    [Fact]
    public void The_function_that_chooses_a_priority_compiles()
    {
        string post = Assert.Single(PostOption().Matches(Desktop)).Value;
        string code = CodeOfWindow("WPF");
        Assert.Empty(WindowCompiler.FindErrors("WPF", code.Replace("MaxRate = 60", $"MaxRate = 60, {post}", StringComparison.Ordinal)));
        Assert.NotEmpty(WindowCompiler.FindErrors("WPF", code.Replace("MaxRate = 60", $"MaxRate = 60, {post}.ToString()", StringComparison.Ordinal)));
    }

    [Fact]
    public void A_snippet_without_its_namespace_does_not_compile() =>
        Assert.NotEmpty(ServerCompiler.FindErrors("BvhDocument take = BvhDocument.Load(\"walk.bvh\");"));

    private static string Desktop => File.ReadAllText(Repository.PathOf("docs", "guide", "desktop.md"));

    private static string CodeOfWindow(string framework) =>
        Assert.Single(Block().Matches(Desktop), block => block.Groups["marker"].Value == $"<!-- needs: {framework} -->\n").Groups["code"].Value;

    [GeneratedRegex("(?<=`)Post = action => Dispatcher[^`]+", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex PostOption();

    [GeneratedRegex("^(?<marker><!-- (program|needs): [^\n]* -->\n)?```csharp\n(?<code>.*?)^```", RegexOptions.Multiline | RegexOptions.Singleline | RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex Block();

    [GeneratedRegex("(?<=')[^']+(?=')", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Quoted();
}
