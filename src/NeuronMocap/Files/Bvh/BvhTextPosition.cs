namespace NeuronMocap.Bvh;

// Line and byte of the line, both from 1; the default value is no place.
internal readonly record struct BvhTextPosition(int Line, int Column);
