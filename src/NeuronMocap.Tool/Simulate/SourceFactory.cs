using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Server;

namespace NeuronMocap.Tool.Simulate;

/// <summary>What the options name as the source of a broadcast.</summary>
/// <param name="Bvh">A BVH file, or null for another source.</param>
/// <param name="Calc">A calculation export, or null for another source; without either the synthetic actor plays.</param>
/// <param name="Avatars">Number of avatars, at least 1.</param>
/// <param name="Loop">Whether a finite take starts again at its end.</param>
internal sealed record SourceSettings(FileInfo? Bvh, FileInfo? Calc, int Avatars, bool Loop);

/// <summary>The performances to broadcast.</summary>
/// <param name="Avatars">One for each avatar.</param>
/// <param name="Order">The file's own rotation order, or null when the source can be asked for any.</param>
/// <param name="Description">What it is, for the line that the program begins with.</param>
internal sealed record SimulatorSources(IReadOnlyList<MotionSource> Avatars, RotationOrder? Order, string Description)
{
    /// <summary>Makes the values of calculation packets: computed, or an export's own.</summary>
    public CalculationProvider WriteCalculation { get; init; } = CalculationSynthesizer.Write;

    /// <summary>Number of those values.</summary>
    public int CalculationValueCount { get; init; } = CalculationFrame.FullValueCount;
}

/// <summary>Makes the performances that the options name. The only place that knows which kinds there are.</summary>
internal static class SourceFactory
{
    /// <summary>Makes the performances.</summary>
    /// <param name="settings">What the options name.</param>
    /// <exception cref="NeuronException">The file is none of its kind, or not one of this skeleton.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static SimulatorSources Create(SourceSettings settings) => settings switch
    {
        { Bvh: { } file } => OpenTake(file, settings),
        { Calc: { } file } => OpenCalculation(file, settings),
        _ => MakeActors(settings.Avatars),
    };

    private static SimulatorSources MakeActors(int count)
    {
        MotionSource[] actors = [.. Enumerable.Range(0, count).Select(avatar => new SyntheticSource(avatarIndex: avatar))];
        return new SimulatorSources(actors, Order: null, "synthetic actor");
    }

    // Every avatar plays the same take.
    private static SimulatorSources OpenTake(FileInfo file, SourceSettings settings)
    {
        BvhDocument document = BvhDocument.Load(file.FullName);
        var take = new BvhSource(document);
        string repairs = document.RepairCount == 0 ? string.Empty : $", {document.RepairCount} repairs, first {document.Repairs[0]}";
        return new SimulatorSources(Repeat(take, settings), take.RotationOrder, Describe(file, take) + repairs);
    }

    private static SimulatorSources OpenCalculation(FileInfo file, SourceSettings settings)
    {
        CalculationDocument document = CalculationDocument.Load(file.FullName);
        var take = new CalculationSource(document);
        string repairs = document.RepairCount == 0 ? string.Empty : $", {document.RepairCount} repairs, first {document.Repairs[0]}";
        string warnings = string.Concat(take.Skeleton.Warnings.Select(static warning => $" {warning}"));
        return new SimulatorSources(Repeat(take, settings), Order: null, Describe(file, take) + repairs + warnings)
        {
            WriteCalculation = take.WriteCalculation,
            CalculationValueCount = take.ValueCount,
        };
    }

    private static MotionSource[] Repeat(MotionSource take, SourceSettings settings) =>
        [.. Enumerable.Repeat(settings.Loop ? new LoopedSource(take) : take, settings.Avatars)];

    private static string Describe(FileInfo file, MotionSource take) =>
        $"{file.Name}: {take.FrameCount} frames at {take.FrameRate:0.##} Hz";
}
