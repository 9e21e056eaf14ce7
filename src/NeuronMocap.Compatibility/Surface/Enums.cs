namespace NeuronDataReaderWraper;

/// <summary>State of a connection or service (manual section 2.1.1).</summary>
public enum SocketStatus
{
    /// <summary>The connection or service works.</summary>
    CS_Running,

    /// <summary>The connection or service is starting.</summary>
    CS_Starting,

    /// <summary>The connection or service does not work: it was never opened, failed, was closed, or was ended by the server.</summary>
    CS_OffWork,
}

/// <summary>
/// Commands. 0 to 8 belong to the data connection (protocol.md section 7). 1001 to 1005 belong to the command channel (manual section
/// 2.1.5, protocol.md section 2.4).
/// </summary>
public enum CmdId
{
    /// <summary>Bone sizes of an avatar: <see cref="CmdResponseBoneSize"/> entries.</summary>
    Cmd_BoneSize,

    /// <summary>Name of an avatar.</summary>
    Cmd_AvatarName,

    /// <summary>Direction in which an avatar faces.</summary>
    Cmd_FaceDirection,

    /// <summary>Frames per second of an avatar.</summary>
    Cmd_DataFrequency,

    /// <summary>BVH header text of an avatar.</summary>
    Cmd_BvhInheritance,

    /// <summary>Number of avatars.</summary>
    Cmd_AvatarCount,

    /// <summary>Sensors that an avatar wears: <see cref="SensorCombinationModes"/>.</summary>
    Cmd_CombinationMode,

    /// <summary>Asks the server to send a value whenever it changes.</summary>
    Cmd_RegisterEvent,

    /// <summary>
    /// Name of command 8 in the C# wrapper. The C library uses this command to end what <see cref="Cmd_RegisterEvent"/> started.
    /// </summary>
    Cmd_SetAvatarName,

    /// <summary>
    /// Command channel: zeroes out one avatar. It is not documented whether this changes the direction, the position or both.
    /// </summary>
    Cmd_ZeroOutPosition = 1001,

    /// <summary>Command channel: zeroes out all avatars, as <see cref="Cmd_ZeroOutPosition"/> does for one.</summary>
    Cmd_ZeroOutAllAvatar,

    /// <summary>Command channel: rotation order of the BVH data.</summary>
    Cmd_BvhRotation,

    /// <summary>Command channel: lengths of the bones. The C header also calls it Cmd_BoneSize, a name that is already used here.</summary>
    Cmd_BoneDimension,

    /// <summary>Command channel: BVH header text.</summary>
    Cmd_BvhHeader,
}

/// <summary>Which sensors are worn.</summary>
public enum SensorCombinationModes
{
    /// <summary>One arm.</summary>
    SC_ArmOnly,

    /// <summary>The upper body.</summary>
    SC_UpperBody,

    /// <summary>The whole body.</summary>
    SC_FullBody,
}

/// <summary>Orders of the three angles of a rotation (manual section 2.1.9).</summary>
public enum RotateOrders
{
    /// <summary>X, then Z, then Y.</summary>
    RO_XZY,

    /// <summary>Y, then X, then Z. This is Axis Neuron's default.</summary>
    RO_YXZ,

    /// <summary>X, then Y, then Z.</summary>
    RO_XYZ,

    /// <summary>Y, then Z, then X.</summary>
    RO_YZX,

    /// <summary>Z, then X, then Y.</summary>
    RO_ZXY,

    /// <summary>Z, then Y, then X.</summary>
    RO_ZYX,

    /// <summary>The order is unknown.</summary>
    RO_Unknown,
}
