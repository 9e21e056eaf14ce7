namespace NeuronMocap;

/// <summary>
/// The order in which a bone's three rotation values are sent and applied (manual section 2.1.9). The numbers are the vendor's.
/// </summary>
/// <remarks>
/// For YXZ the values are Y, X, Z, and the rotation is R(Y) · R(X) · R(Z) on column vectors. An Axis Neuron frame does not carry the order. Set it on
/// the reader to match the server (protocol.md section 3.1).
/// </remarks>
public enum RotationOrder
{
    /// <summary>X, then Z, then Y.</summary>
    XZY = 0,

    /// <summary>Y, then X, then Z: the default of Axis Neuron.</summary>
    YXZ = 1,

    /// <summary>X, then Y, then Z.</summary>
    XYZ = 2,

    /// <summary>Y, then Z, then X.</summary>
    YZX = 3,

    /// <summary>Z, then X, then Y.</summary>
    ZXY = 4,

    /// <summary>Z, then Y, then X.</summary>
    ZYX = 5,
}
