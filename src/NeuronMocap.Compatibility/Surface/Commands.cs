using System.Runtime.InteropServices;

namespace NeuronDataReaderWraper;

/// <summary>Header of an answer to a command on the data connection, 64 bytes (protocol.md section 2.6).</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
public struct CommandPack
{
    /// <summary>The start token, 0xAAFF.</summary>
    public ushort Token1;

    /// <summary>Version of the command format.</summary>
    public uint DataVersion;

    /// <summary>
    /// Length of the packet in bytes. Servers are not exact about it. <see cref="DataCount"/> gives the amount of data that follows.
    /// </summary>
    public uint DataLength;

    /// <summary>Number of entries that follow: bone sizes, or bytes of text.</summary>
    public uint DataCount;

    /// <summary>The command that is answered.</summary>
    public CmdId CommandId;

    /// <summary>Parameters, 40 bytes. Their meaning depends on the command.</summary>
    [MarshalAs(UnmanagedType.ByValArray, SizeConst = 40)]
    public byte[] CmdParaments;

    /// <summary>Reserved, as sent by the server.</summary>
    public uint Reserved1;

    /// <summary>The end token, 0xBBFF.</summary>
    public ushort Token2;
}

/// <summary>Length of one bone in an answer to <see cref="CmdId.Cmd_BoneSize"/>, 64 bytes.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
public struct CmdResponseBoneSize
{
    /// <summary>Name of the bone.</summary>
    [MarshalAs(UnmanagedType.ByValTStr, SizeConst = 60)]
    public string BoneName;

    /// <summary>Length of the bone, in the unit of the server.</summary>
    public float BoneLength;
}

/// <summary>Dimensions of a body in metres, 48 bytes (manual section 2.1.8).</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
public struct BoneDimension
{
    /// <summary>Length of the head.</summary>
    public float Head;

    /// <summary>Length of the neck.</summary>
    public float Neck;

    /// <summary>Length of the body.</summary>
    public float Body;

    /// <summary>Width of the shoulders.</summary>
    public float ShoulderWidth;

    /// <summary>Length of the upper arm.</summary>
    public float UpperArm;

    /// <summary>Length of the forearm.</summary>
    public float Forearm;

    /// <summary>Length of the hand.</summary>
    public float Palm;

    /// <summary>Width of the hips.</summary>
    public float HipWidth;

    /// <summary>Length of the upper leg.</summary>
    public float UpperLeg;

    /// <summary>Length of the lower leg.</summary>
    public float LowerLeg;

    /// <summary>Height of the heel.</summary>
    public float HeelHeight;

    /// <summary>Length of the foot.</summary>
    public float FootLength;
}
