using System.Text.RegularExpressions;
using NeuronMocap.Packaging.Tests.Infrastructure;

namespace NeuronMocap.Packaging.Tests.Documentation;

// The scripts on the pages are put into projects as they are.
public sealed partial class ExampleTests
{
    public static TheoryData<string, string> Examples
    {
        get
        {
            TheoryData<string, string> examples = [];
            foreach (string page in Directory.EnumerateFiles(ThePackage.Folder, "*.md", SearchOption.AllDirectories).Order(StringComparer.Ordinal))
            {
                foreach (Match block in Block().Matches(File.ReadAllText(page)))
                    examples.Add(Path.GetRelativePath(ThePackage.Folder, page), block.Groups["code"].Value);
            }

            return examples;
        }
    }

    [Theory]
    [MemberData(nameof(Examples))]
    public void An_example_compiles_in_a_project_that_has_the_package(string page, string code) =>
        Assert.Empty(new UnityCompiler(ThePackage.Staged, isEditor: false).FindErrors(code).Select(problem => $"{page}: {problem}"));

    [Fact]
    public void An_example_with_a_name_that_there_is_not_does_not_compile() =>
        Assert.NotEmpty(new UnityCompiler(ThePackage.Staged, isEditor: false).FindErrors("class Example { NeuronMocap.Unity.MocapSauce source; }"));

    [GeneratedRegex("^```csharp\n(?<code>.*?)^```", RegexOptions.Multiline | RegexOptions.Singleline | RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Block();
}
