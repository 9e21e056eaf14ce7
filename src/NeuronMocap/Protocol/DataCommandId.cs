namespace NeuronMocap.Protocol;

/// <summary>
/// What a command on the data connection is about: the "CmdId" of the vendor's b11 and b12 libraries (protocol.md sections 2.4 and 7).
/// Requests and replies carry the same number.
/// </summary>
public enum DataCommandId
{
    /// <summary>Names and lengths of an avatar's bones.</summary>
    BoneSize = 0,

    /// <summary>An avatar's name. How a reply carries it is not known.</summary>
    AvatarName = 1,

    /// <summary>The direction that an avatar faces. How a reply carries it is not known.</summary>
    FaceDirection = 2,

    /// <summary>Frames per second of an avatar.</summary>
    DataFrequency = 3,

    /// <summary>The hierarchy of an avatar as the text of a BVH file: "BvhInheritance" with the vendor.</summary>
    BvhText = 4,

    /// <summary>Number of avatars on the server.</summary>
    AvatarCount = 5,

    /// <summary>Which sensors an avatar wears.</summary>
    CombinationMode = 6,

    /// <summary>Asks the server to send a value again whenever it changes; the parameter tells which.</summary>
    RegisterEvent = 7,

    /// <summary>Takes <see cref="RegisterEvent"/> back. Older C# scripts call the number "Cmd_SetAvatarName".</summary>
    UnregisterEvent = 8,
}
