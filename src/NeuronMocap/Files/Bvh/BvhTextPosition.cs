namespace NeuronMocap.Bvh;

// A line and a byte within the line, both from 1. The default value is not a position.
internal readonly record struct BvhTextPosition(int Line, int Column);
