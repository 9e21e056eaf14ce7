namespace NeuronMocap.Bvh;

/// <summary>Describes the position data lost by removing displacement: positions relative to the parent that differ from the new OFFSET.</summary>
/// <param name="MaxError">The largest distance, in the file's unit of length (Axis Neuron: centimetres); 0 when nothing was lost.</param>
/// <param name="Joint">Name of the joint with the largest distance; null when nothing was lost.</param>
/// <param name="Frame">The frame with the largest distance, from 0.</param>
public readonly record struct PositionChannelLoss(double MaxError, string? Joint, int Frame);
