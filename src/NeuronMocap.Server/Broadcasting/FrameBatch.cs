namespace NeuronMocap.Server.Broadcasting;

// What a feed has written: whole frames of all avatars.
internal readonly record struct FrameBatch(int Bytes, int Frames);
