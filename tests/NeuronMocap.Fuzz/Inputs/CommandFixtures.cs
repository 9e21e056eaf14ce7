using NeuronMocap.Bvh;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Fuzz.Inputs;

/// <summary>Replies of a command server, single and in sequence.</summary>
internal static class CommandFixtures
{
    /// <summary>Tokens, command numbers, and sizes at limits.</summary>
    public static IReadOnlyList<byte[]> Words { get; } =
    [
        [0xFF, 0xAA], [0xFF, 0xBB], [0xFF], .. Enumerable.Range(1000, 7).Select(id => BitConverter.GetBytes((ushort)id)),
        .. ((int[])[-1, 0, 1, 3, 4, 5, 47, 48, 49, 4_095, 4_096, 4_097, 100_000, int.MaxValue, int.MinValue]).Select(BitConverter.GetBytes),
        .. ((float[])[float.NaN, float.PositiveInfinity, -0.0f, -1, 0.28f]).Select(BitConverter.GetBytes),
    ];

    public static IReadOnlyList<byte[]> Create()
    {
        byte[] sizes = new byte[BoneDimensions.Size];
        new BoneDimensions { Head = 0.17f, Body = 0.51f, FootLength = 0.25f }.Write(sizes);
        byte[] header = System.Text.Encoding.ASCII.GetBytes(BvhHierarchyText.Create(SkeletonFormat.Default, default));
        byte[][] replies =
        [
            Packet(CommandChannelId.ZeroOut, [1, 0, 0, 0]),
            Packet(CommandChannelId.ZeroOutAll, [0, 0, 0, 0]),
            Packet(CommandChannelId.RotationOrder, [4, 0, 0, 0]),
            Packet(CommandChannelId.RotationOrder, [2]),
            Packet(CommandChannelId.BoneDimensions, sizes),
            Packet(CommandChannelId.BoneDimensions, []),
            Packet(CommandChannelId.BvhHeader, header[..2_000]),
            Packet(CommandChannelId.BvhHeader, "HIERARCHY\nROOT Hips\n{\nOFFSET 0 1 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n}\n\0"u8.ToArray()),
        ];
        byte[] noise = [.. "GET / HTTP/1.1\r\n"u8, 0xFF, 0xAA, 0xFF];
        byte[] mixed = [.. replies[0], .. noise, .. replies[4], .. replies[2], .. replies[0][..15], .. replies[7], .. replies[3]];
        return [.. replies, mixed, noise];
    }

    private static byte[] Packet(CommandChannelId id, byte[] payload)
    {
        byte[] packet = new byte[CommandChannelHeader.Size + payload.Length];
        new CommandChannelHeader { CommandId = (ushort)id, PayloadSize = payload.Length }.Write(packet);
        payload.CopyTo(packet, CommandChannelHeader.Size);
        return packet;
    }
}
