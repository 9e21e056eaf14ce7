using System.Reflection;
using System.Runtime.Versioning;
using NeuronMocap.Tests.Infrastructure;

namespace NeuronMocap.Tests.Architecture;

/// <summary>
/// The public surface of each library against the text file of its name in PublicApi: what a change does to users is seen in its diff.
/// A line of the file that only one of the two builds has starts with that build's name in brackets.
/// </summary>
public sealed class PublicApiTests
{
    private const string UpdateVariable = "NEURONMOCAP_UPDATE_API";

    private static readonly string[] Targets = ["[net8.0] ", "[netstandard2.1] "];

    public static TheoryData<string> Assemblies => DependencyTests.Assemblies;

    [Theory, MemberData(nameof(Assemblies))]
    public void The_public_surface_is_the_one_on_file(string name)
    {
        var assembly = Assembly.Load(name);
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

    [Fact]
    public void Every_kind_of_member_is_written()
    {
        const string type = "NeuronMocap.Tests.Architecture.SurfaceSample<T>";
        IReadOnlyList<string> all = PublicSurface.Of(typeof(PublicApiTests).Assembly);
        string[] lines = [.. all.Where(line => line.StartsWith(type, StringComparison.Ordinal))];
        Assert.Equal(
            ((string[])
            [
                $"{type} [abstract class] : System.IDisposable where T : class, new()",
                $"{type}.Changed -> event System.Action<string?>?",
                $"{type}.Dispose() -> void",
                $"{type}.Find(System.ReadOnlySpan<byte> bytes, out string? text, in int start, params object[] rest) -> bool [static]",
                $"{type}.Limit -> int = 7 [const]",
                $"{type}.Make<TItem>(T? item, System.DayOfWeek day = System.DayOfWeek.Friday, System.Threading.CancellationToken token = default)"
                    + " -> System.Collections.Generic.List<TItem[]?> where TItem : struct [protected] [abstract]",
                $"{type}.Name {{ get; init; }} -> string? [required]",
                $"{type}.State {{ get; protected set; }} -> int? [virtual]",
                $"{type}.ToString() -> string [override]",
                $"{type}.ctor() [protected]",
                $"{type}.op_Implicit(NeuronMocap.Tests.Architecture.SurfaceSample<T> value) -> int [static]",
                $"{type}.this[int index] {{ get; }} -> double",
            ]).Order(StringComparer.Ordinal).ToArray(),
            lines);
    }

    private static bool IsOf(string line, string target) =>
        line.StartsWith(target, StringComparison.Ordinal) || !Targets.Any(other => line.StartsWith(other, StringComparison.Ordinal));

    private static string Strip(string line, string target) => line.StartsWith(target, StringComparison.Ordinal) ? line[target.Length..] : line;

    // A line that was marked as this build's own stays marked; one of the other build stays unless this build has it now too.
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
