using System.Reflection;
using NeuronMocap.Server;

namespace NeuronMocap.Tests.Architecture;

public sealed class DependencyTests
{
    // Bytes (Transport) become packets (Protocol), then frames (Frames), and reach a queue (Delivery). The root and Reader connect them.
    private static readonly DependencyRules Client = new("/src/NeuronMocap/", new Dictionary<string, string[]>(StringComparer.Ordinal)
    {
        ["Polyfills"] = [],
        ["Skeleton"] = [],
        ["Motion"] = ["Skeleton"],
        ["Figures"] = ["Skeleton"],
        ["Retargeting"] = ["Skeleton"],
        ["Protocol"] = ["Protocol/Text"],
        ["Protocol/Text"] = ["Protocol"],
        ["Transport"] = ["Protocol", "Protocol/Text"],
        ["Frames"] = ["Protocol", "Skeleton"],
        ["Json"] = ["Frames", "Protocol", "Skeleton"],
        ["Delivery"] = ["Frames", "Protocol", "Skeleton"],
        ["Delivery/OnContext"] = ["Delivery", "Frames", "Protocol", "Skeleton", "Transport"],
        ["Binding"] = ["", "Delivery", "Delivery/OnContext", "Protocol", "Transport"],
        ["Timing"] = ["Frames"],
        ["Diagnostics"] = ["Frames", "Protocol", "Transport"],
        ["Files"] = [],
        ["Files/Bvh"] = ["Files", "Frames", "Protocol", "Protocol/Text", "Skeleton", "Timing"],
        ["Files/Calculation"] = ["Files", "Frames", "Protocol", "Protocol/Text", "Skeleton"],
        ["Files/Csv"] = ["Files", "Protocol", "Protocol/Text", "Skeleton"],
        ["Files/Recording"] = ["Files", "Protocol", "Skeleton", "Transport"],
        ["Files/Gltf"] = ["Figures", "Files", "Motion", "Skeleton"],
        ["Files/Playback"] = ["Delivery", "Files/Recording", "Frames", "Protocol", "Skeleton", "Transport"],
        // A server sends text in BVH format. Connecting, and reasons for failures, are the same as for a stream.
        ["Commands"] = ["Delivery", "Files/Bvh", "Protocol", "Skeleton", "Transport"],
        ["Files/Bvh/Export"] = ["Commands", "Delivery", "Files", "Files/Bvh", "Frames", "Protocol", "Skeleton", "Transport"],
        ["Telemetry"] = ["Delivery", "Files", "Files/Recording", "Protocol", "Transport"],
        ["Reader"] =
        [
            "", "Commands", "Delivery", "Delivery/OnContext", "Diagnostics", "Files", "Files/Bvh", "Files/Recording", "Frames", "Protocol", "Protocol/Text", "Skeleton", "Telemetry",
            "Transport",
        ],
    });

    // Performances (Sources) become packets (Broadcasting), which reach the receivers (Clients). The root connects them.
    private static readonly DependencyRules Server = new("/src/NeuronMocap.Server/", new Dictionary<string, string[]>(StringComparer.Ordinal)
    {
        ["Faults"] = [],
        ["Sources/Synthetic"] = [],
        ["Sources"] = ["Sources/Synthetic"],
        ["Options"] = ["Faults", "Sources"],
        ["Broadcasting"] = ["Faults", "Options", "Sources"],
        ["Clients"] = ["Broadcasting", "Faults", "Options", "Sources"],
        // Poses of a reader for other programs, and poses of other programs for a reader.
        ["Osc"] = [],
    });

    // Packages that the net8.0 builds declare and that are not part of the framework.
    private static readonly string[] Declared = ["Microsoft.Extensions.Logging.Abstractions"];

    // What the netstandard2.0 builds declare, with the packages that those bring.
    private static readonly string[] Declared20 =
    [
        "netstandard", "Microsoft.Bcl.AsyncInterfaces", "System.Buffers", "System.Memory", "System.Numerics.Vectors", "System.Runtime.CompilerServices.Unsafe",
        "System.Threading.Tasks.Extensions",
    ];

    public static TheoryData<string> Assemblies => [typeof(MotionFrame).Assembly.GetName().Name!, typeof(MotionSource).Assembly.GetName().Name!];

    [Fact]
    public void Client_folders_depend_on_each_other_as_designed()
    {
        List<string> violations = Client.Violations(typeof(MotionFrame).Assembly);
        Assert.True(violations.Count == 0, string.Join(Environment.NewLine, violations));
    }

    [Fact]
    public void Server_folders_depend_on_each_other_as_designed()
    {
        List<string> violations = Server.Violations(typeof(MotionSource).Assembly);
        Assert.True(violations.Count == 0, string.Join(Environment.NewLine, violations));
    }

    [Fact]
    public void The_rules_allow_no_cycle()
    {
        Assert.Empty(Client.Circles());
        Assert.Empty(Server.Circles());
    }

    [Theory, MemberData(nameof(Assemblies))]
    public void A_library_references_only_the_framework_and_its_declared_dependencies(string name)
    {
        var library = Assembly.Load(name);
        string[] own = name is "NeuronMocap" ? [] : ["NeuronMocap"];
        string[] foreign = [.. library.GetReferencedAssemblies().Select(reference => reference.Name!).Except(own, StringComparer.Ordinal)];

        switch (LibraryBuild.FrameworkOf(library))
        {
            case "netstandard2.1":
                Assert.Equal(["netstandard"], foreign);
                break;
            case "netstandard2.0":
                Assert.Empty(foreign.Except(Declared20, StringComparer.Ordinal));
                break;
            default:
                Assert.All(foreign.Except(Declared), reference => Assert.StartsWith("System.", reference, StringComparison.Ordinal));
                break;
        }
    }

    [Theory, MemberData(nameof(Assemblies))]
    public void The_tests_run_against_the_build_that_was_asked_for(string name) => Assert.True(LibraryBuild.Holds(Assembly.Load(name)));

    [Fact]
    public void Every_way_of_using_a_forbidden_type_is_found()
    {
        var rules = new DependencyRules("/Architecture/Samples/", new Dictionary<string, string[]>(StringComparer.Ordinal)
        {
            ["Low"] = [],
            ["High"] = ["Low"],
        });

        IEnumerable<string> offenders = rules.Violations(typeof(DependencyTests).Assembly).Select(Offender);

        Assert.Equal(
            [
                "AsArgument", "AsArray", "AsAttribute", "AsBase", "AsCall", "AsConstraint", "AsEvent", "AsField", "AsGenericArgument", "AsLambda",
                "AsLocal", "AsNested", "AsParameter", "AsProperty", "AsResult", "AsTypeOf", "OfRoot", "Unruled",
            ],
            offenders.Distinct(StringComparer.Ordinal).Order(StringComparer.Ordinal).ToArray());
    }

    // "System.Void Root.Low.AsCall::Use() uses ..." -> "AsCall"
    private static string Offender(string violation)
    {
        string member = violation.Split(["::", " uses ", ": ", "/"], StringSplitOptions.None)[0].Split(' ')[^1];
        return member.Split('.')[^1].Split('`')[0];
    }
}
