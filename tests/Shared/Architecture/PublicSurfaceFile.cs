using System.Reflection;
using System.Runtime.Versioning;

namespace NeuronMocap.Tests.Architecture;

/// <summary>The file in PublicApi for comparison with a library's public surface.</summary>
internal static class PublicSurfaceFile
{
    private const string UpdateVariable = "NEURONMOCAP_UPDATE_API";

    private static readonly string[] Targets = ["[net8.0] ", "[netstandard2.1] "];

    public static void Check(Assembly assembly)
    {
        string name = assembly.GetName().Name!;
        string target = assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName.StartsWith(".NETStandard", StringComparison.Ordinal)
            ? Targets[1]
            : Targets[0];
        string path = Repository.PathOf("tests", "NeuronMocap.Tests", "PublicApi", name + ".txt");
        string[] file = File.Exists(path) ? File.ReadAllLines(path) : [];
        IReadOnlyList<string> actual = PublicSurface.Of(assembly);
        string[] expected = [.. file.Where(line => IsOf(line, target)).Select(line => Strip(line, target))];

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
            The public surface of {name} ({target.Trim()}) differs from tests/NeuronMocap.Tests/PublicApi/{name}.txt:
            {string.Join(Environment.NewLine, differences)}
            If that is meant, run this test with {UpdateVariable}=1 to rewrite the file, and commit it with the change.
            """);
    }

    private static bool IsOf(string line, string target) =>
        line.StartsWith(target, StringComparison.Ordinal) || !Targets.Any(other => line.StartsWith(other, StringComparison.Ordinal));

    private static string Strip(string line, string target) => line.StartsWith(target, StringComparison.Ordinal) ? line[target.Length..] : line;

    // A line marked as this build's own stays marked. A line of the other build stays marked unless this build now has it too.
    private static IEnumerable<string> Updated(string[] file, IReadOnlyList<string> actual, string target)
    {
        string other = Targets.Single(one => !string.Equals(one, target, StringComparison.Ordinal));
        HashSet<string> own = [.. file.Where(line => line.StartsWith(target, StringComparison.Ordinal)).Select(line => line[target.Length..])];
        return
        [
            .. file.Where(line => !IsOf(line, target) && !actual.Contains(Strip(line, other), StringComparer.Ordinal)),
            .. actual.Select(line => own.Contains(line) ? target + line : line),
        ];
    }
}
