using NeuronMocap.Tests.Architecture;

namespace NeuronMocap.Unity.Tests.Package;

/// <summary>Rules for the use of folders in the runtime part of the package.</summary>
public sealed class RuntimeDependencyTests
{
    // Frames come from sources, and drivers pose a rig with them. Figures are rigs built by the package. Recorders ask drivers which bones move. The root
    // converts axes and units.
    private static readonly DependencyRules Runtime = new("/unity-package/Runtime/", new Dictionary<string, string[]>(StringComparer.Ordinal)
    {
        ["Sources"] = [""],
        ["Drivers"] = ["", "Sources"],
        ["Figures"] = ["", "Drivers", "Sources"],
        ["Recorders"] = ["", "Drivers", "Sources"],
        ["DebugViews"] = ["", "Drivers", "Sources"],
    });

    [Fact]
    public void Runtime_folders_depend_on_each_other_as_designed()
    {
        List<string> violations = Runtime.Violations(typeof(MocapSource).Assembly);
        Assert.True(violations.Count == 0, string.Join(Environment.NewLine, violations));
    }

    [Fact]
    public void The_rules_allow_no_cycle() => Assert.Empty(Runtime.Circles());
}
