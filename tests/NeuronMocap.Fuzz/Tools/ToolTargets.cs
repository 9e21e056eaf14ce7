using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Tools;

/// <summary>The monitor's file tools, run in this process.</summary>
internal static class ToolTargets
{
    private const long Allocated = 48 * 1024 * 1024;

    public static IReadOnlyList<FuzzTarget> All { get; } = [Create("info", FileVerb.Info), Create("convert", FileVerb.Convert), Create("plot", FileVerb.Plot)];

    private static FuzzTarget Create(string name, FileVerb task)
    {
        var target = new Lazy<FileToolTarget>(() => new FileToolTarget(task));
        return new FuzzTarget(name, CorpusKind.Files, () => target.Value.Run)
        {
            Share = 0.25,
            AllocatesOnOtherThreads = true,
            AllocatedPerInput = Allocated,
            AllocatedPerByte = 4096,
            Stop = () => target.Value.Stop(),
            CountOutput = () => target.IsValueCreated ? target.Value.CountOutput() : 0,
        };
    }
}
