using System.Reflection;

namespace NeuronMocap.Tests.Architecture;

/// <summary>The file in PublicApi for comparison with a library's public surface.</summary>
internal static class PublicSurfaceFile
{
    private const string UpdateVariable = "NEURONMOCAP_UPDATE_API";

    private static readonly string[] Targets = ["net8.0", "netstandard2.1", "netstandard2.0"];

    public static void Check(Assembly assembly)
    {
        string name = assembly.GetName().Name!;
        string target = LibraryBuild.FrameworkOf(assembly);
        string path = Repository.PathOf("tests", "NeuronMocap.Tests", "PublicApi", name + ".txt");
        string[] file = File.Exists(path) ? File.ReadAllLines(path) : [];
        IReadOnlyList<string> actual = PublicSurface.Of(assembly);
        string[] expected = [.. file.Where(line => IsOf(line, target)).Select(Strip)];

        if (Environment.GetEnvironmentVariable(UpdateVariable) is "1")
        {
            File.WriteAllLines(path, Updated(file, actual, target));
            return;
        }

        string[] differences =
        [
            .. expected.Except(actual, StringComparer.Ordinal).Select(line => "- " + line),
            .. actual.Except(expected, StringComparer.Ordinal).Select(line => "+ " + line),
        ];
        Assert.True(
            differences.Length == 0,
            $"""
            The public surface of {name} ({target}) differs from tests/NeuronMocap.Tests/PublicApi/{name}.txt:
            {string.Join(Environment.NewLine, differences)}
            If that is meant, run this test with {UpdateVariable}=1 to rewrite the file, and commit it with the change.
            """);
    }

    // The builds that a line names in brackets; none if all have it.
    private static string[] BuildsOf(string line)
    {
        int end = line.StartsWith('[') ? line.IndexOf("] ", StringComparison.Ordinal) : -1;
        string[] builds = end < 0 ? [] : line[1..end].Split(' ');
        return builds.All(static build => Targets.Contains(build, StringComparer.Ordinal)) ? builds : [];
    }

    private static bool IsOf(string line, string target) => BuildsOf(line) is var builds && (builds.Length == 0 || builds.Contains(target, StringComparer.Ordinal));

    private static string Strip(string line) => BuildsOf(line).Length == 0 ? line : line[(line.IndexOf("] ", StringComparison.Ordinal) + 2)..];

    // A line marked as of this build stays marked. A line of other builds stays marked unless this build now has it too.
    private static IEnumerable<string> Updated(string[] file, IReadOnlyList<string> actual, string target)
    {
        Dictionary<string, string> own = file.Where(line => BuildsOf(line).Contains(target, StringComparer.Ordinal)).ToDictionary(Strip, StringComparer.Ordinal);
        return
        [
            .. file.Where(line => !IsOf(line, target) && !actual.Contains(Strip(line), StringComparer.Ordinal)),
            .. actual.Select(line => own.GetValueOrDefault(line, line)),
        ];
    }
}
