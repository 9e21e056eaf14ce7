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
    /// <summary>Computes calculation packets; null while there are none to be had.</summary>
    public static CalculationWriter? Calculation => null;

    /// <summary>Makes the performances.</summary>
    /// <param name="settings">What the options name.</param>
    /// <exception cref="UsageException">The options ask for something that this program does not have.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="InvalidDataException">The file is not a take of this skeleton.</exception>
    public static SimulatorSources Create(SourceSettings settings) => throw new UsageException(
        settings.Bvh is null ? "--synthetic: this build has no synthetic actor." : "--bvh: this build cannot read BVH files.");
}
