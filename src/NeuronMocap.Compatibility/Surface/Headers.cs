using System.Runtime.InteropServices;

namespace NeuronDataReaderWraper;

/// <summary>Version of the stream's data format, lowest part first (manual section 2.1.2).</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
public struct DataVersion
{
    /// <summary>Fourth part.</summary>
    public byte BuildNumb;

    /// <summary>Third part.</summary>
    public byte Revision;

    /// <summary>Second part.</summary>
    public byte Minor;

    /// <summary>First part.</summary>
    public byte Major;
}

/// <summary>
/// Header of a frame of BVH data, 64 bytes (manual section 2.1.3). The header pointer of <see cref="FrameDataReceived"/> points to it.
/// </summary>
/// <remarks>
/// A frame that arrived with the old header or as text has this layout, too. Its version is then 1.1.0.0, and this library counts its frame index.
/// </remarks>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
public struct BvhDataHeader
{
    /// <summary>The start token, 0xDDFF.</summary>
    public ushort Token1;

    /// <summary>Version of the data format.</summary>
    public DataVersion DataVersion;

    /// <summary>Number of floats in the frame.</summary>
    public ushort DataCount;

    /// <summary>1 if every bone carries a position, otherwise 0.</summary>
    public byte bWithDisp;

    /// <summary>1 if the reference comes first, otherwise 0.</summary>
    public byte bWithReference;

    /// <summary>Index of the avatar, from 0.</summary>
    public uint AvatarIndex;

    /// <summary>Name of the avatar.</summary>
    [MarshalAs(UnmanagedType.ByValTStr, SizeConst = 32)]
    public string AvatarName;

    /// <summary>The frame index of the server.</summary>
    public uint FrameIndex;

    /// <summary>Reserved, as sent by the server. In Axis Studio: the rotation order.</summary>
    public uint Reserved;

    /// <summary>Reserved, as sent by the server. In Axis Studio: hours, minutes and seconds of the timecode.</summary>
    public uint Reserved1;

    /// <summary>Reserved, as sent by the server. In Axis Studio: the frame of the timecode.</summary>
    public uint Reserved2;

    /// <summary>The end token, 0xEEFF.</summary>
    public ushort Token2;

    /// <summary>Name of <see cref="Token1"/> in the wrappers up to b14.</summary>
    public ushort HeaderToken1
    {
        readonly get => Token1;
        set => Token1 = value;
    }

    /// <summary>Name of <see cref="Token2"/> in the wrappers up to b14.</summary>
    public ushort HeaderToken2
    {
        readonly get => Token2;
        set => Token2 = value;
    }
}

/// <summary>Header of a frame of calculation data (manual section 2.1.4), 64 bytes.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
public struct CalcDataHeader
{
    /// <summary>The start token, 0x88FF.</summary>
    public ushort Token1;

    /// <summary>Version of the data format.</summary>
    public DataVersion DataVersion;

    /// <summary>Number of floats in the frame.</summary>
    public uint DataCount;

    /// <summary>Index of the avatar, from 0.</summary>
    public uint AvatarIndex;

    /// <summary>Name of the avatar.</summary>
    [MarshalAs(UnmanagedType.ByValTStr, SizeConst = 32)]
    public string AvatarName;

    /// <summary>The frame index of the server.</summary>
    public uint FrameIndex;

    /// <summary>Reserved, as sent by the server.</summary>
    public uint Reserved1;

    /// <summary>Reserved, as sent by the server.</summary>
    public uint Reserved2;

    /// <summary>Reserved, as sent by the server.</summary>
    public uint Reserved3;

    /// <summary>The end token, 0x99FF.</summary>
    public ushort Token2;
}
