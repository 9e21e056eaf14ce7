using System.Text.RegularExpressions;
using NeuronMocap.Tests.Infrastructure;

namespace NeuronMocap.Packaging.Tests.Documentation;

/// <summary>Links between the pages of the repository.</summary>
public sealed partial class LinkTests
{
    private static readonly string[] Folders = ["docs", "samples", "src", "unity-package"];

    public static TheoryData<string> Pages =>
    [
        .. Directory.GetFiles(Repository.Root, "*.md").Concat(Folders.SelectMany(folder => Directory.GetFiles(Repository.PathOf(folder), "*.md", SearchOption.AllDirectories)))
            .Select(path => Path.GetRelativePath(Repository.Root, path)),
    ];

    [Theory, MemberData(nameof(Pages))]
    public void Every_relative_link_exists(string page)
    {
        string path = Repository.PathOf(page);
        string text = Code().Replace(File.ReadAllText(path), "");

        Assert.All(Link().Matches(text), link =>
        {
            string file = link.Groups["file"].Value;
            string target = file.Length == 0 ? path : Path.GetFullPath(Path.Combine(Path.GetDirectoryName(path)!, file));
            Assert.True(Path.Exists(target), $"{page} links to {file}, which is not there.");
            if (link.Groups["anchor"] is { Success: true, Value: string anchor })
                Assert.True(AnchorsOf(target).Contains(anchor), $"{page} links to {file}#{anchor}, which has no such heading.");
        });
    }

    [Fact]
    public void The_index_lists_every_page()
    {
        string index = File.ReadAllText(Repository.PathOf("docs", "README.md"));
        Assert.All(
            Directory.GetFiles(Repository.PathOf("docs"), "*.md", SearchOption.AllDirectories).Select(static path => Path.GetRelativePath(Repository.PathOf("docs"), path).Replace('\\', '/')).Where(static page => page != "README.md"),
            page => Assert.Contains($"]({page})", index, StringComparison.Ordinal));
    }

    private static IEnumerable<string> AnchorsOf(string path) => Heading().Matches(Code().Replace(File.ReadAllText(path), ""))
        .Select(static heading => NoAnchor().Replace(heading.Groups["title"].Value.ToLowerInvariant(), "").Trim().Replace(' ', '-'));

    [GeneratedRegex("```.*?```", RegexOptions.Singleline | RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex Code();

    [GeneratedRegex(@"\]\((?!https?:|mailto:)(?<file>[^)#\s]*)(#(?<anchor>[^)\s]+))?\)", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex Link();

    [GeneratedRegex("^#+ (?<title>.*)$", RegexOptions.Multiline | RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex Heading();

    [GeneratedRegex(@"[^\w -]", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex NoAnchor();
}
