using NeuronMocap.Tests.Architecture;
using NeuronMocap.Unity.EditorTools;

namespace NeuronMocap.Unity.Tests.Editor;

/// <summary>Which folders of the package's editor part may use which.</summary>
public sealed class EditorDependencyTests
{
    // Reports are what windows and inspectors show; rigs and the diagnosis fill them. The root has what several of them draw with.
    private static readonly DependencyRules Editor = new("/unity-package/Editor/", new Dictionary<string, string[]>(StringComparer.Ordinal)
    {
        ["Build"] = [""],
        ["Diagnosis"] = ["", "Reports"],
        ["Menus"] = [""],
        ["Preview"] = [""],
        ["Recorders"] = [""],
        ["Reports"] = [""],
        ["Rigs"] = ["", "Reports"],
        ["Inspectors"] = ["", "Diagnosis", "Recorders", "Reports", "Rigs"],
        ["Window"] = ["", "Diagnosis", "Preview", "Reports"],
    });

    [Fact]
    public void Editor_folders_depend_on_each_other_as_designed()
    {
        List<string> violations = Editor.Violations(typeof(SourcesWindow).Assembly);
        Assert.True(violations.Count == 0, string.Join(Environment.NewLine, violations));
    }

    [Fact]
    public void The_rules_allow_no_cycle() => Assert.Empty(Editor.Circles());
}
