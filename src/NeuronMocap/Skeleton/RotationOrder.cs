namespace NeuronMocap;

/// <summary>
/// The order in which a bone's three rotation values stand and are applied (manual section 2.1.9; the numbers are the vendor's).
/// YXZ means: the values are Y, X, Z, and the rotation is R(Y) · R(X) · R(Z) on column vectors. An Axis Neuron frame does not carry
/// the order: the reader has to be told what the server is set to (protocol.md section 3.1).
/// </summary>
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
