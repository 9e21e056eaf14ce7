using NeuronMocap.Bvh;
using NeuronMocap.Server.Sources;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Simulator;

/// <summary>What the options name as the source of a broadcast.</summary>
/// <param name="Bvh">A BVH file, or null for the synthetic actor.</param>
/// <param name="Avatars">Number of avatars, at least 1.</param>
/// <param name="Loop">Whether a finite take starts again at its end.</param>
internal sealed record SourceSettings(FileInfo? Bvh, int Avatars, bool Loop);

/// <summary>The performances to broadcast.</summary>
/// <param name="Avatars">One for each avatar.</param>
/// <param name="Order">The file's own rotation order, or null when the source can be asked for any.</param>
/// <param name="Description">What it is, for the line that the program begins with.</param>
internal sealed record SimulatorSources(IReadOnlyList<MotionSource> Avatars, RotationOrder? Order, string Description);

/// <summary>Makes the performances that the options name. The only place that knows which kinds there are.</summary>
internal static class SourceFactory
{
    /// <summary>Makes the performances.</summary>
    /// <param name="settings">What the options name.</param>
    /// <exception cref="NeuronException">The file is no BVH file, or not one of this skeleton.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static SimulatorSources Create(SourceSettings settings) =>
        settings.Bvh is { } file ? OpenTake(file, settings) : MakeActors(settings.Avatars);

    private static SimulatorSources MakeActors(int count)
    {
        MotionSource[] actors = [.. Enumerable.Range(0, count).Select(avatar => new SyntheticActor(avatar: avatar))];
        return new SimulatorSources(actors, Order: null, "synthetic actor");
    }

    // Every avatar plays the same take.
    private static SimulatorSources OpenTake(FileInfo file, SourceSettings settings)
    {
        BvhDocument document = BvhDocument.Load(file.FullName);
        var take = new BvhSource(document);
        MotionSource source = settings.Loop ? new LoopedSource(take) : take;
        string repairs = document.RepairCount == 0 ? string.Empty : $", {document.RepairCount} repairs, first {document.Repairs[0]}";
        return new SimulatorSources(
            [.. Enumerable.Repeat(source, settings.Avatars)],
            take.RotationOrder,
            $"{file.Name}: {document.FrameCount} frames at {document.FrameRate:0.##} Hz{repairs}");
    }
}
