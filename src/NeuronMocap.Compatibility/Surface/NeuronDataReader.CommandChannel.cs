using System.Runtime.InteropServices;
using System.Text;
using NeuronMocap;
using NeuronMocap.Compatibility;
using NeuronMocap.Skeleton;

namespace NeuronDataReaderWraper;

/// <content>
/// The command channel of b17 and b18, a TCP connection of its own (manual sections 2.3.9 to 2.3.14, protocol.md section 6). The vendor's C# wrappers
/// lack it; names and parameters are those of the C functions. A call takes 3 s at most once it has a connection. It is false for everything
/// that is no right answer, sets the last error where something came that cannot be an answer, and otherwise leaves it alone.
/// </content>
public partial class NeuronDataReader
{
    /// <summary>Connects to a server's command port (manual section 2.3.9) and returns when the connection stands, or after about 5 s.</summary>
    /// <param name="serverIP">The server's address or name.</param>
    /// <param name="nPort">The server's command port: a setting there, 8013 unless changed. Not the port of the stream.</param>
    /// <returns>
    /// The connection, or zero: <see cref="strBRGetLastErrorMessage"/> tells why. Where there is a living one to the same address and port,
    /// that one.
    /// </returns>
    public static IntPtr BRConnectCmd(string serverIP, int nPort) => Functions.ConnectCommands(serverIP, nPort);

    /// <summary>Asks the server to zero out an avatar (manual section 2.3.10). What that changes, the direction, the position or both, is not documented.</summary>
    /// <param name="sockRef">A command connection.</param>
    /// <param name="avatarIndex">Number of the avatar, from 0.</param>
    /// <returns>Whether the server said that it did.</returns>
    public static bool ZeroOut(IntPtr sockRef, int avatarIndex) => VendorFunctions.ZeroOut(sockRef, avatarIndex);

    /// <summary>Asks the server to zero out all avatars (manual section 2.3.11), as <see cref="ZeroOut"/> does for one.</summary>
    /// <param name="sockRef">A command connection.</param>
    /// <returns>Whether the server said that it did.</returns>
    public static bool ZeroOutAll(IntPtr sockRef) => VendorFunctions.ZeroOutAll(sockRef);

    /// <summary>Asks for the rotation order of the BVH data (manual section 2.3.12).</summary>
    /// <param name="sockRef">A command connection.</param>
    /// <param name="order">The order, or <see cref="RotateOrders.RO_Unknown"/>.</param>
    /// <returns>Whether the server told one of the six.</returns>
    public static bool GetBvhRotation(IntPtr sockRef, out RotateOrders order)
    {
        // The numbers are the same.
        bool told = VendorFunctions.TryGetRotationOrder(sockRef, out RotationOrder answer);
        order = told ? (RotateOrders)answer : RotateOrders.RO_Unknown;
        return told;
    }

    /// <summary>Asks for the sizes of an avatar's body (manual section 2.3.13).</summary>
    /// <param name="sockRef">A command connection.</param>
    /// <param name="avatarIndex">Number of the avatar, from 0.</param>
    /// <param name="dimensions">The sizes in metres; all 0 where the server told none.</param>
    /// <returns>Whether the server told them.</returns>
    public static bool GetBoneSize(IntPtr sockRef, int avatarIndex, out BoneDimension dimensions)
    {
        bool told = VendorFunctions.TryGetBoneDimensions(sockRef, avatarIndex, out BoneDimensions answer);
        dimensions = new BoneDimension
        {
            Head = answer.Head,
            Neck = answer.Neck,
            Body = answer.Body,
            ShoulderWidth = answer.ShoulderWidth,
            UpperArm = answer.UpperArm,
            Forearm = answer.Forearm,
            Palm = answer.Palm,
            HipWidth = answer.HipWidth,
            UpperLeg = answer.UpperLeg,
            LowerLeg = answer.LowerLeg,
            HeelHeight = answer.HeelHeight,
            FootLength = answer.FootLength,
        };
        return told;
    }

    /// <summary>Asks for what the BVH file of an avatar begins with (manual section 2.3.14 and Appendix B).</summary>
    /// <param name="sockRef">A command connection.</param>
    /// <param name="avatarIndex">Number of the avatar, from 0.</param>
    /// <param name="data">Filled with the text.</param>
    /// <param name="len">Longest text to take, in characters; the rest is cut off. A header has about 10,000.</param>
    /// <returns>Whether the server told it; false when <paramref name="len"/> is not positive.</returns>
    public static bool GetBvhHeader(IntPtr sockRef, int avatarIndex, StringBuilder data, int len)
    {
        if (data is null || len <= 0 || !VendorFunctions.TryGetBvhHeader(sockRef, avatarIndex, out string? text))
            return false;

        data.Clear().Append(text, 0, Math.Min(Math.Min(len, text.Length), data.MaxCapacity));
        return true;
    }

    /// <summary>As the one with a text, with UTF-8 bytes; a zero byte follows them where there is room.</summary>
    /// <param name="sockRef">A command connection.</param>
    /// <param name="avatarIndex">Number of the avatar, from 0.</param>
    /// <param name="data">Room for the text.</param>
    /// <param name="len">Largest number of bytes to write; the rest is cut off.</param>
    /// <returns>Whether the server told it; false when there is no room.</returns>
    public static bool GetBvhHeader(IntPtr sockRef, int avatarIndex, byte[] data, int len)
    {
        int room = Math.Min(len, data?.Length ?? 0);
        if (room <= 0 || !VendorFunctions.TryGetBvhHeader(sockRef, avatarIndex, out byte[]? bytes))
            return false;

        bytes.AsSpan(0, Math.Min(room, bytes.Length)).CopyTo(data);
        return true;
    }

    /// <summary>As the one with bytes, with memory of the caller's.</summary>
    /// <param name="sockRef">A command connection.</param>
    /// <param name="avatarIndex">Number of the avatar, from 0.</param>
    /// <param name="data">Room for <paramref name="len"/> bytes.</param>
    /// <param name="len">Largest number of bytes to write; the rest is cut off.</param>
    /// <returns>Whether the server told it; false when there is no room.</returns>
    public static bool GetBvhHeader(IntPtr sockRef, int avatarIndex, IntPtr data, int len)
    {
        if (data == IntPtr.Zero || len <= 0 || !VendorFunctions.TryGetBvhHeader(sockRef, avatarIndex, out byte[]? bytes))
            return false;

        Marshal.Copy(bytes, 0, data, Math.Min(len, bytes.Length));
        return true;
    }
}
