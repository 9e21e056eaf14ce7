namespace NeuronMocap.Protocol;

/// <summary>
/// The value that a command on the data connection is about: the "CmdId" of the vendor's b11 and b12 libraries (protocol.md sections 2.4 and 7). Requests
/// and replies have the same number.
/// </summary>
public enum DataCommandId
{
    /// <summary>Names and lengths of an avatar's bones.</summary>
    BoneSize = 0,

    /// <summary>An avatar's name. It is not known how a reply contains it.</summary>
    AvatarName = 1,

    /// <summary>The direction that an avatar faces. It is not known how a reply contains it.</summary>
    FaceDirection = 2,

    /// <summary>Frames per second of an avatar.</summary>
    DataFrequency = 3,

    /// <summary>The hierarchy of an avatar as the text of a BVH file. The vendor calls it "BvhInheritance".</summary>
    BvhText = 4,

    /// <summary>Number of avatars on the server.</summary>
    AvatarCount = 5,

    /// <summary>The set of sensors that an avatar wears.</summary>
    CombinationMode = 6,

    /// <summary>Asks the server to send a value whenever it changes; the parameter says which value.</summary>
    RegisterEvent = 7,

    /// <summary>Cancels <see cref="RegisterEvent"/>. Older C# scripts call this number "Cmd_SetAvatarName".</summary>
    UnregisterEvent = 8,
}
