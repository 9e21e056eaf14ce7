namespace NeuronMocap.Protocol;

/// <summary>The commands of the command channel (manual sections 2.3.10 to 2.3.14, protocol.md sections 2.4 and 6).</summary>
public enum CommandChannelId
{
    /// <summary>Zeroes out one avatar. The effect, on direction, position or both, is not documented.</summary>
    ZeroOut = 1001,

    /// <summary>Zeroes out all avatars.</summary>
    ZeroOutAll = 1002,

    /// <summary>Requests the order of the rotation values.</summary>
    RotationOrder = 1003,

    /// <summary>Requests the sizes of an avatar's body.</summary>
    BoneDimensions = 1004,

    /// <summary>Requests the header of an avatar's BVH file.</summary>
    BvhHeader = 1005,
}
