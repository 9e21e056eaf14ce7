using System.Text.RegularExpressions;
using NeuronMocap.Tests.Infrastructure;

namespace NeuronMocap.Packaging.Tests.Documentation;

/// <summary>Links between the pages of the repository.</summary>
public sealed partial class LinkTests
{
    private static readonly string[] Folders = ["docs", "samples", "unity-package"];

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
            string target = Path.GetFullPath(Path.Combine(Path.GetDirectoryName(path)!, link.Groups["target"].Value));
            Assert.True(Path.Exists(target), $"{page} links to {link.Groups["target"].Value}, which is not there.");
        });
    }

    [GeneratedRegex("```.*?```", RegexOptions.Singleline | RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex Code();

    [GeneratedRegex(@"\]\((?!https?:|#|mailto:)(?<target>[^)#\s]+)", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex Link();
}
