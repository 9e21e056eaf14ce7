using NeuronMocap.Tests.Architecture;
using NeuronMocap.Unity.EditorTools;

namespace NeuronMocap.Unity.Tests.Editor;

/// <summary>Rules for the use of folders in the editor part of the package.</summary>
public sealed class EditorDependencyTests
{
    // Windows and inspectors show reports. Rigs, the diagnosis and the migration create them. The root has the shared drawing code.
    private static readonly DependencyRules Editor = new("/unity-package/Editor/", new Dictionary<string, string[]>(StringComparer.Ordinal)
    {
        ["Build"] = [""],
        ["Diagnosis"] = ["", "Reports"],
        ["Menus"] = ["", "Rigs"],
        ["Migration"] = ["", "Reports"],
        ["Preview"] = [""],
        ["Recorders"] = [""],
        ["Reports"] = [""],
        ["Rigs"] = ["", "Reports"],
        ["Inspectors"] = ["", "Diagnosis", "Preview", "Recorders", "Reports", "Rigs"],
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
