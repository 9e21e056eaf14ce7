namespace NeuronMocap.Server.Broadcasting;

// What a feed has written: whole packets in a row, the first of which has this place in its frame.
internal readonly record struct FrameBatch(int Bytes, int Packets, int First = 0);
