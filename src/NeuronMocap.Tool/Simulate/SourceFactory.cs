using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Server;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Simulate;

/// <summary>The source that the options name.</summary>
/// <param name="Bvh">A BVH file, or null for another source.</param>
/// <param name="Calc">A calculation export, or null for another source. Without either file the synthetic walk plays.</param>
/// <param name="Avatars">Number of avatars, at least 1.</param>
/// <param name="Loop">Whether a finite take restarts at its end.</param>
internal sealed record SourceSettings(FileInfo? Bvh, FileInfo? Calc, int Avatars, bool Loop);

/// <summary>The sources to broadcast.</summary>
/// <param name="Avatars">One source for each avatar.</param>
/// <param name="Order">Rotation order of the file, or null if the source supports any order.</param>
/// <param name="Description">Description for the first line that the program writes.</param>
internal sealed record SimulatorSources(IReadOnlyList<MotionSource> Avatars, RotationOrder? Order, string Description)
{
    /// <summary>Provides the values of calculation packets: computed, or those of an export.</summary>
    public CalculationProvider WriteCalculation { get; init; } = CalculationSynthesizer.Write;

    /// <summary>Number of those values.</summary>
    public int CalculationValueCount { get; init; } = CalculationFrame.FullValueCount;
}

/// <summary>Creates the sources that the options name. Only this class knows the kinds of sources.</summary>
internal static class SourceFactory
{
    /// <summary>Creates the sources.</summary>
    /// <param name="settings">The source that the options name.</param>
    /// <exception cref="NeuronException">The file has another format, or another skeleton.</exception>
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
        BvhFile.RequireRows(document);
        var take = new BvhSource(document);
        string repairs = document.RepairCount == 0 ? string.Empty : $", {document.RepairCount} {Quantity.Noun(document.RepairCount, "repair")}, first {document.Repairs[0]}";
        return new SimulatorSources(Repeat(take, settings), take.RotationOrder, Describe(file, take) + repairs);
    }

    private static SimulatorSources OpenCalculation(FileInfo file, SourceSettings settings)
    {
        CalculationDocument document = CalculationDocument.Load(file.FullName);
        var take = new CalculationSource(document);
        string repairs = document.RepairCount == 0 ? string.Empty : $", {document.RepairCount} {Quantity.Noun(document.RepairCount, "repair")}, first {document.Repairs[0]}";
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
        $"{file.Name}: {take.FrameCount} {Quantity.Noun(take.FrameCount ?? 0, "frame")} at {take.FrameRate:0.##} Hz";
}
