namespace NeuronMocap;

/// <summary>The two layouts of a motion header. Both have 64 bytes and the same tokens; the data version distinguishes them.</summary>
public enum HeaderLayout
{
    /// <summary>Data version 1.1, with a frame index (b15 and later, Axis Neuron, Axis Studio; protocol.md section 2.1).</summary>
    New,

    /// <summary>Data version 1.0, without a frame index, with flags of 32 bits (up to b12; protocol.md section 2.2).</summary>
    Old,
}
