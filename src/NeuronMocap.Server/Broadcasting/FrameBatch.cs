namespace NeuronMocap.Server.Broadcasting;

// The output of a feed: consecutive whole packets. First is the index of the first packet in its frame.
internal readonly record struct FrameBatch(int Bytes, int Packets, int First = 0);
