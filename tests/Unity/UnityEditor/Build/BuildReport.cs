namespace UnityEditor.Build.Reporting;

public sealed class BuildReport
{
    public BuildSummary summary { get; internal set; }

    /// <summary>For tests.</summary>
    public static BuildReport Of(BuildTarget platform, string outputPath = "") =>
        new() { summary = new BuildSummary { platform = platform, outputPath = outputPath } };
}
