using NeuronMocap.Tests.Architecture;

namespace NeuronMocap.Tool.Tests.Architecture;

public sealed class ToolDependencyTests
{
    // Shared folders first. Of the verbs, plot and info read files as convert does, and play is watch with a file. The root connects all verbs.
    private static readonly DependencyRules Tool = new("/src/NeuronMocap.Tool/", new Dictionary<string, string[]>(StringComparer.Ordinal)
    {
        ["Terminal"] = [],
        ["Figures"] = [],
        ["Files"] = ["Terminal"],
        ["Arguments"] = ["Files", "Terminal"],
        ["Output"] = ["Files", "Terminal"],
        ["Commands"] = ["Arguments", "Files", "Terminal"],
        ["Completion"] = ["Arguments", "Terminal"],
        ["Convert"] = ["Arguments", "Files", "Terminal"],
        ["Diagnose"] = ["Arguments", "Files", "Output", "Terminal"],
        ["Info"] = ["Arguments", "Convert", "Figures", "Files", "Terminal"],
        ["Plot"] = ["Arguments", "Convert", "Figures", "Files", "Terminal"],
        ["Simulate"] = ["Arguments", "Files", "Terminal"],
        ["Watch/Export"] = ["Arguments", "Files", "Terminal"],
        ["Watch/Playback"] = ["Arguments", "Files", "Terminal"],
        ["Watch/Recordings"] = ["Arguments", "Files", "Output", "Terminal", "Watch/Export"],
        ["Watch/Live"] = ["Arguments", "Figures", "Output", "Terminal", "Watch/Playback", "Watch/Recordings"],
        ["Watch"] = ["Arguments", "Files", "Output", "Terminal", "Watch/Export", "Watch/Live", "Watch/Playback", "Watch/Recordings"],
        ["Listening"] = [],
        ["Relay/Destinations"] = ["Arguments", "Files", "Listening", "Simulate", "Terminal", "Watch/Export", "Watch/Recordings"],
        ["Relay"] = ["Arguments", "Files", "Output", "Relay/Destinations", "Simulate", "Terminal", "Watch", "Watch/Live", "Watch/Playback", "Watch/Recordings"],
        ["View/Web"] = [],
        ["View/Access"] = ["Terminal"],
        ["View/Performers"] = [],
        ["View/Control"] = ["View/Performers", "View/Web"],
        ["View/Figures"] = ["View/Performers", "View/Web"],
        ["View/Live"] = ["Output", "View/Control", "View/Performers", "View/Web", "Watch/Live"],
        ["View/Takes"] = ["Convert", "Files", "Terminal", "View/Control", "View/Figures", "View/Performers", "View/Web"],
        ["View/Characters"] = ["View/Live", "View/Performers", "View/Takes", "View/Web"],
        ["View/Actions"] = ["Arguments", "Output", "Terminal", "View/Control", "View/Live", "View/Takes", "View/Web", "Watch/Recordings"],
        ["View"] =
        [
            "Arguments", "Listening", "Simulate", "Terminal", "View/Access", "View/Actions", "View/Characters", "View/Control", "View/Figures", "View/Live",
            "View/Performers", "View/Takes", "View/Web",
        ],
        ["Play"] = ["Arguments", "Terminal", "Watch", "Watch/Export", "Watch/Playback"],
    });

    [Fact]
    public void Folders_depend_on_each_other_as_designed()
    {
        List<string> violations = Tool.Violations(typeof(CommandLine).Assembly);
        Assert.True(violations.Count == 0, string.Join(Environment.NewLine, violations));
    }

    [Fact]
    public void The_rules_allow_no_cycle() => Assert.Empty(Tool.Circles());
}
