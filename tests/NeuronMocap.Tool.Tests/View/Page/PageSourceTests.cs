using System.IO.Compression;
using System.Reflection;
using System.Text.Json;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.Tests.View.Page;

public sealed class PageSourceTests
{
    private const int LongestFile = 350;

    private static readonly Assembly Program = typeof(PageFiles).Assembly;

    [Fact]
    public async Task The_tests_of_the_page_pass()
    {
        (int code, string output) = await NodeProgram.RunAsync("test.mjs");
        Assert.True(code == 0, output);
        Assert.Contains("# fail 0", output, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_types_of_the_page_fit()
    {
        (int code, string output) = await NodeProgram.RunAsync("node_modules/typescript/bin/tsc", "--noEmit");
        Assert.True(code == 0, output);
    }

    [Fact]
    public void The_program_contains_the_page()
    {
        Assert.SkipUnless(NodeProgram.Exists, "Without Node, the program is built without the page.");
        foreach (string name in (string[])["index.html", "app.js", "app.css", "licenses.txt"])
        {
            using Stream? file = Program.GetManifestResourceStream($"web/{name}.gz");
            Assert.True(file is { Length: > 50 }, $"The program does not contain {name}.");
        }
    }

    [Fact]
    public void The_licences_of_the_packages_in_the_page_are_in_the_program()
    {
        Assert.SkipUnless(NodeProgram.Exists, "Without Node, the program is built without the page.");
        using var reader = new StreamReader(new GZipStream(Program.GetManifestResourceStream("web/licenses.txt.gz")!, CompressionMode.Decompress));
        string licences = reader.ReadToEnd();
        Assert.Contains("three 0.", licences, StringComparison.Ordinal);
        Assert.Contains("@pixiv/three-vrm 3.", licences, StringComparison.Ordinal);
        Assert.Contains("The MIT License", licences, StringComparison.Ordinal);
    }

    [Fact]
    public void Versions_are_exact_and_the_lock_file_has_checksums_and_no_addresses()
    {
        using var manifest = JsonDocument.Parse(File.ReadAllText(Repository.PathOf("web", "package.json")));
        foreach (string group in (string[])["dependencies", "devDependencies"])
        {
            foreach (JsonProperty package in manifest.RootElement.GetProperty(group).EnumerateObject())
                Assert.Matches(@"^\d+\.\d+\.\d+(-[\w.]+)?$", package.Value.GetString());
        }

        string text = File.ReadAllText(Repository.PathOf("web", "package-lock.json"));
        Assert.DoesNotContain("\"resolved\"", text, StringComparison.Ordinal);
        using var lockFile = JsonDocument.Parse(text);
        foreach (JsonProperty package in lockFile.RootElement.GetProperty("packages").EnumerateObject().Where(static package => package.Name.Length > 0))
            Assert.True(package.Value.TryGetProperty("integrity", out _), $"{package.Name} has no checksum.");
    }

    [Fact]
    public void Sources_are_short_and_ask_no_other_server()
    {
        string[] sources = Directory.GetFiles(Repository.PathOf("web", "src"), "*", SearchOption.AllDirectories);
        string[] files = [.. sources, Repository.PathOf("web", "index.html")];
        Assert.NotEmpty(files);
        foreach (string file in files)
        {
            string text = File.ReadAllText(file);
            Assert.True(text.Count(static character => character == '\n') <= LongestFile, $"{file} has more than {LongestFile} lines.");
            foreach (string line in text.Split('\n').Where(static line => line.Contains("://", StringComparison.Ordinal)))
                Assert.True(line.Contains("http://www.w3.org/", StringComparison.Ordinal), $"{file} names another server: {line.Trim()}");
        }
    }
}
