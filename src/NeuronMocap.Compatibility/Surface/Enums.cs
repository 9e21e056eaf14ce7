namespace NeuronDataReaderWraper;

/// <summary>State of a connection or service (manual section 2.1.1).</summary>
public enum SocketStatus
{
    /// <summary>Working correctly.</summary>
    CS_Running,

    /// <summary>Trying to start.</summary>
    CS_Starting,

    /// <summary>Not working: never opened, failed, closed, or left by the server.</summary>
    CS_OffWork,
}

/// <summary>
/// Commands. 0 to 8 are those of the data connection (protocol.md section 7), 1001 to 1005 those of the command channel (manual section
/// 2.1.5, protocol.md section 2.4).
/// </summary>
public enum CmdId
{
    /// <summary>Bone sizes of an avatar: <see cref="CmdResponseBoneSize"/> entries.</summary>
    Cmd_BoneSize,

    /// <summary>Name of an avatar.</summary>
    Cmd_AvatarName,

    /// <summary>Direction that an avatar faces.</summary>
    Cmd_FaceDirection,

    /// <summary>Frames per second of an avatar.</summary>
    Cmd_DataFrequency,

    /// <summary>BVH header text of an avatar.</summary>
    Cmd_BvhInheritance,

    /// <summary>Number of avatars.</summary>
    Cmd_AvatarCount,

    /// <summary>Sensors worn: <see cref="SensorCombinationModes"/>.</summary>
    Cmd_CombinationMode,

    /// <summary>Asks the server to send a value whenever it changes.</summary>
    Cmd_RegisterEvent,

    /// <summary>The C# wrapper's name of number 8, by which the C library ends what <see cref="Cmd_RegisterEvent"/> began.</summary>
    Cmd_SetAvatarName,

    /// <summary>Command channel: zeroes out one avatar. What that changes, the direction, the position or both, is not documented.</summary>
    Cmd_ZeroOutPosition = 1001,

    /// <summary>Command channel: as <see cref="Cmd_ZeroOutPosition"/>, for all avatars.</summary>
    Cmd_ZeroOutAllAvatar,

    /// <summary>Command channel: rotation order of the BVH data.</summary>
    Cmd_BvhRotation,

    /// <summary>Command channel: lengths of the bones. The C header calls it Cmd_BoneSize too, a name that is taken here.</summary>
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

/// <summary>Orders in which the three angles of a rotation stand (manual section 2.1.9).</summary>
public enum RotateOrders
{
    /// <summary>X, then Z, then Y.</summary>
    RO_XZY,

    /// <summary>Y, then X, then Z: Axis Neuron's default.</summary>
    RO_YXZ,

    /// <summary>X, then Y, then Z.</summary>
    RO_XYZ,

    /// <summary>Y, then Z, then X.</summary>
    RO_YZX,

    /// <summary>Z, then X, then Y.</summary>
    RO_ZXY,

    /// <summary>Z, then Y, then X.</summary>
    RO_ZYX,

    /// <summary>Not known.</summary>
    RO_Unknown,
}
