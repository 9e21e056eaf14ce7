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
        "reader", "options", "builder", "running", "avatar", "actor", "rig", "retargeter", "pose", "localPose", "world", "body", "seconds",
        "Apply", "Draw", "PlantFeet", "Render", "Show", "ShowPose",
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
        string page = File.ReadAllText(Repository.PathOf("docs", "guide", "desktop.md"));
        Match block = Assert.Single(Block().Matches(page), block => block.Groups["marker"].Value == $"<!-- needs: {framework} -->\n");
        Assert.Empty(WindowCompiler.FindErrors(framework, block.Groups["code"].Value));
        Assert.NotEmpty(WindowCompiler.FindErrors(framework, block.Groups["code"].Value.Replace("_reader.Start()", "_reader.Begin()", StringComparison.Ordinal)));
    }

    [Fact]
    public void A_snippet_without_its_namespace_does_not_compile() =>
        Assert.NotEmpty(ServerCompiler.FindErrors("BvhDocument take = BvhDocument.Load(\"walk.bvh\");"));

    [GeneratedRegex("^(?<marker><!-- (program|needs): [^\n]* -->\n)?```csharp\n(?<code>.*?)^```", RegexOptions.Multiline | RegexOptions.Singleline | RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex Block();

    [GeneratedRegex("(?<=')[^']+(?=')", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Quoted();
}
