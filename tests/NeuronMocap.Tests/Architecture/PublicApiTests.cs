using System.Reflection;

namespace NeuronMocap.Tests.Architecture;

/// <summary>
/// Compares the public surface of each library with the text file of its name in PublicApi, whose diff shows how a change affects users. A line that
/// not all builds have starts with the names of those that have it, in brackets.
/// </summary>
public sealed class PublicApiTests
{
    public static TheoryData<string> Assemblies => DependencyTests.Assemblies;

    [Theory, MemberData(nameof(Assemblies))]
    public void The_public_API_matches_its_file(string name) => PublicSurfaceFile.Check(Assembly.Load(name));

    /// <summary>
    /// A framework type in a signature could differ between the builds. A library compiled against one build would then not find the member in
    /// another.
    /// </summary>
    [Theory, MemberData(nameof(Assemblies))]
    public void All_builds_have_the_same_signatures_of_init_accessors(string name)
    {
        var assembly = Assembly.Load(name);
        IEnumerable<string?> scopes = assembly.GetExportedTypes()
            .SelectMany(static type => type.GetProperties(BindingFlags.DeclaredOnly | BindingFlags.Public | BindingFlags.Instance))
            .SelectMany(static property => property.SetMethod?.ReturnParameter.GetRequiredCustomModifiers() ?? [])
            .Select(static modifier => modifier.Assembly.GetName().Name)
            .Distinct();
        Assert.All(scopes, scope => Assert.Equal(name, scope));
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
                $"{type}.Make<TItem>(T? item, System.DayOfWeek day = System.DayOfWeek.Friday, System.Threading.CancellationToken cancellationToken = default)"
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
}
