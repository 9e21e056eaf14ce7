namespace NeuronMocap.Protocol;

/// <summary>The commands of the command channel (manual sections 2.3.10 to 2.3.14, protocol.md sections 2.4 and 6).</summary>
public enum CommandChannelId
{
    /// <summary>Zeroes out one avatar. What that changes, the direction, the position or both, is not documented.</summary>
    ZeroOut = 1001,

    /// <summary>Zeroes out all avatars.</summary>
    ZeroOutAll = 1002,

    /// <summary>Asks for the order of the rotation values.</summary>
    RotationOrder = 1003,

    /// <summary>Asks for the sizes of an avatar's body.</summary>
    BoneDimensions = 1004,

    /// <summary>Asks for the text that an avatar's BVH file begins with.</summary>
    BvhHeader = 1005,
}
