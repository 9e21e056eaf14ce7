using System.Globalization;
using System.Text;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Native.Tests.Generations;

/// <summary>A frame as the b12 program prints it.</summary>
internal static class B12Frame
{
    /// <summary>Returns the line for <see cref="TestPackets.Motion"/>, including the image, assembled field by field.</summary>
    public static string LineOf(string socket, int frame, int avatar = 0, int count = 354, string name = "Char00", string version = "1.0.0.2", int compressed = 0, int reserved = 0)
    {
        (int displacement, int reference) = (count >= 354 ? 1 : 0, count is 186 or 360 ? 1 : 0);
        byte[] versionBytes = [.. version.Split('.').Reverse().Select(static part => byte.Parse(part, CultureInfo.InvariantCulture))];
        byte[] image = new WireBytes()
            .Hex("FF DD").Bytes(versionBytes, 4).U32((uint)count).U32((uint)displacement).U32((uint)reference).U32((uint)avatar)
            .Bytes(Encoding.UTF8.GetBytes(name), 32).U32((uint)compressed).U32((uint)reserved).Hex("FF EE")
            .ToArray();
        return string.Create(
            CultureInfo.InvariantCulture,
            $"frame frames {socket} version {version} count {count} displacement {displacement} reference {reference} avatar {avatar} '{name}' "
            + $"compressed {compressed} reserved {reserved} first {TestPackets.Value(frame, avatar, 0):G9} last {TestPackets.Value(frame, avatar, count - 1):G9} "
            + $"{Convert.ToHexString(image)}");
    }

    /// <summary>Creates a frame of version 1.0.3.4 with both reserved fields set.</summary>
    public static byte[] OldPacket(int frame, int compressed, int reserved)
    {
        byte[] packet = TestPackets.Motion(frame, layout: HeaderLayout.Old);
        new WireBytes().Hex("04 03 00 01").ToArray().CopyTo(packet, 2);
        BitConverter.GetBytes(compressed).CopyTo(packet, 54);
        BitConverter.GetBytes(reserved).CopyTo(packet, 58);
        return packet;
    }
}
