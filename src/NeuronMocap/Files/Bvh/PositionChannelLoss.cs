namespace NeuronMocap.Bvh;

/// <summary>What a take lost with its displacement: positions relative to the parent that were not the new OFFSET.</summary>
/// <param name="MaxError">The largest distance, in the file's unit of length (Axis Neuron: centimetres); 0 when nothing was lost.</param>
/// <param name="Joint">Name of the joint that had it; null when nothing was lost.</param>
/// <param name="Frame">The frame that had it, from 0.</param>
public readonly record struct PositionChannelLoss(double MaxError, string? Joint, int Frame);
