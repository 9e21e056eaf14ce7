using System.Runtime.InteropServices;
using System.Text;
using NeuronMocap;
using NeuronMocap.Compatibility;
using NeuronMocap.Skeleton;

namespace NeuronDataReaderWraper;

/// <content>
/// The command channel of b17 and b18, a separate TCP connection (manual sections 2.3.9 to 2.3.14, protocol.md section 6). The vendor's C# wrappers
/// lack it, so names and parameters are those of the C functions. Once connected, a call takes at most 3 s. It returns false for everything that is
/// not a correct answer. An impossible answer sets the last error; other failures leave the last error unchanged.
/// </content>
public partial class NeuronDataReader
{
    /// <summary>Connects to the command port of a server (manual section 2.3.9). Returns when the connection is open, or after about 5 s.</summary>
    /// <param name="serverIP">Address or name of the server.</param>
    /// <param name="nPort">Command port of the server: a setting of the server, 8013 by default. It is not the port of the stream.</param>
    /// <returns>
    /// The connection, or an existing open connection to the same address and port. Zero on failure; <see cref="strBRGetLastErrorMessage"/> then
    /// gives the reason.
    /// </returns>
    public static IntPtr BRConnectCmd(string serverIP, int nPort) => Functions.ConnectCommands(serverIP, nPort);

    /// <summary>Asks the server to zero out an avatar (manual section 2.3.10).</summary>
    /// <remarks>It is not documented whether this changes the direction, the position or both.</remarks>
    /// <param name="sockRef">A command connection.</param>
    /// <param name="avatarIndex">Index of the avatar, from 0.</param>
    /// <returns>Whether the server confirmed it.</returns>
    public static bool ZeroOut(IntPtr sockRef, int avatarIndex) => VendorFunctions.ZeroOut(sockRef, avatarIndex);

    /// <summary>Asks the server to zero out all avatars (manual section 2.3.11), as <see cref="ZeroOut"/> does for one.</summary>
    /// <param name="sockRef">A command connection.</param>
    /// <returns>Whether the server confirmed it.</returns>
    public static bool ZeroOutAll(IntPtr sockRef) => VendorFunctions.ZeroOutAll(sockRef);

    /// <summary>Asks for the rotation order of the BVH data (manual section 2.3.12).</summary>
    /// <param name="sockRef">A command connection.</param>
    /// <param name="order">The order, or <see cref="RotateOrders.RO_Unknown"/>.</param>
    /// <returns>Whether the server answered with one of the six orders.</returns>
    public static bool GetBvhRotation(IntPtr sockRef, out RotateOrders order)
    {
        // The numbers are the same.
        bool succeeded = VendorFunctions.TryGetRotationOrder(sockRef, out RotationOrder answer);
        order = succeeded ? (RotateOrders)answer : RotateOrders.RO_Unknown;
        return succeeded;
    }

    /// <summary>Asks for the sizes of an avatar's body (manual section 2.3.13).</summary>
    /// <param name="sockRef">A command connection.</param>
    /// <param name="avatarIndex">Index of the avatar, from 0.</param>
    /// <param name="dimensions">The sizes in metres. All are 0 if the server sent none.</param>
    /// <returns>Whether the server sent the sizes.</returns>
    public static bool GetBoneSize(IntPtr sockRef, int avatarIndex, out BoneDimension dimensions)
    {
        bool succeeded = VendorFunctions.TryGetBoneDimensions(sockRef, avatarIndex, out BoneDimensions answer);
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
        return succeeded;
    }

    /// <summary>Asks for the start of an avatar's BVH file (manual section 2.3.14 and Appendix B).</summary>
    /// <param name="sockRef">A command connection.</param>
    /// <param name="avatarIndex">Index of the avatar, from 0.</param>
    /// <param name="data">Receives the text.</param>
    /// <param name="len">Maximum length of the text in characters; the rest is cut off. A header has about 10,000 characters.</param>
    /// <returns>Whether the server sent the text. False if <paramref name="len"/> is not positive.</returns>
    public static bool GetBvhHeader(IntPtr sockRef, int avatarIndex, StringBuilder data, int len)
    {
        if (data is null || len <= 0 || !VendorFunctions.TryGetBvhHeader(sockRef, avatarIndex, out string? text))
            return false;

        data.Clear().Append(text, 0, Math.Min(Math.Min(len, text.Length), data.MaxCapacity));
        return true;
    }

    /// <summary>Asks for the start of an avatar's BVH file as UTF-8 bytes. A zero byte follows if there is room.</summary>
    /// <param name="sockRef">A command connection.</param>
    /// <param name="avatarIndex">Index of the avatar, from 0.</param>
    /// <param name="data">Room for the text.</param>
    /// <param name="len">Maximum number of bytes to write; the rest is cut off.</param>
    /// <returns>Whether the server sent the text. False if there is no room.</returns>
    public static bool GetBvhHeader(IntPtr sockRef, int avatarIndex, byte[] data, int len)
    {
        int room = Math.Min(len, data?.Length ?? 0);
        if (room <= 0 || !VendorFunctions.TryGetBvhHeader(sockRef, avatarIndex, out byte[]? bytes))
            return false;

        bytes.AsSpan(0, Math.Min(room, bytes.Length)).CopyTo(data);
        return true;
    }

    /// <summary>Asks for the start of an avatar's BVH file as UTF-8 bytes in memory of the caller. A zero byte follows if there is room.</summary>
    /// <param name="sockRef">A command connection.</param>
    /// <param name="avatarIndex">Index of the avatar, from 0.</param>
    /// <param name="data">Pointer to room for <paramref name="len"/> bytes.</param>
    /// <param name="len">Maximum number of bytes to write; the rest is cut off.</param>
    /// <returns>Whether the server sent the text. False if there is no room.</returns>
    public static bool GetBvhHeader(IntPtr sockRef, int avatarIndex, IntPtr data, int len)
    {
        if (data == IntPtr.Zero || len <= 0 || !VendorFunctions.TryGetBvhHeader(sockRef, avatarIndex, out byte[]? bytes))
            return false;

        Marshal.Copy(bytes, 0, data, Math.Min(len, bytes.Length));
        return true;
    }
}
