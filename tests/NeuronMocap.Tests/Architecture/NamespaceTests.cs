using System.Reflection;

namespace NeuronMocap.Tests.Architecture;

public sealed class NamespaceTests
{
    public static TheoryData<string> Assemblies => DependencyTests.Assemblies;

    // User code has "using NeuronDataReaderWraper;" and calls "NeuronDataReader.BRConnectTo(...)". A top-level namespace of that name would hide the
    // vendor's class. The vendor's Unity scripts declare Neuron and Noitom. All of our types are therefore inside NeuronMocap.
    [Theory, MemberData(nameof(Assemblies))]
    public void Every_namespace_begins_with_NeuronMocap(string assembly)
    {
        foreach (Type type in OwnTypes(assembly))
        {
            string top = (type.Namespace ?? "").Split('.')[0];
            Assert.True(top is "NeuronMocap", $"{type.FullName} stands in {type.Namespace ?? "the global namespace"}.");
        }
    }

    [Theory, MemberData(nameof(Assemblies))]
    public void No_type_is_named_like_a_part_of_its_namespace(string assembly)
    {
        foreach (Type type in OwnTypes(assembly))
            Assert.DoesNotContain(type.Name.Split('`')[0], type.Namespace!.Split('.'), StringComparer.Ordinal);
    }

    [Theory, MemberData(nameof(Assemblies))]
    public void Polyfills_are_internal(string assembly)
    {
        foreach (Type type in Assembly.Load(assembly).GetTypes().Where(IsFrameworkName))
            Assert.False(type.IsVisible, $"{type.FullName} is public.");
    }

    private static IEnumerable<Type> OwnTypes(string assembly) =>
        Assembly.Load(assembly).GetTypes().Where(type => !IsFrameworkName(type) && !IsGenerated(type));

    private static bool IsFrameworkName(Type type) => (type.Namespace ?? "").Split('.')[0] is "System" or "Microsoft";

    private static bool IsGenerated(Type type) =>
        type.Name.StartsWith('<') || (type.DeclaringType is { } outer && IsGenerated(outer));
}
