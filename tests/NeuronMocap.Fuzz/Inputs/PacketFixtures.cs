using System.Buffers.Binary;
using System.Runtime.InteropServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Fuzz.Inputs;

/// <summary>Packets of every kind and size, single and in sequence.</summary>
internal static class PacketFixtures
{
    /// <summary>Tokens, versions, and counts at limits in both widths.</summary>
    public static IReadOnlyList<byte[]> Words { get; } =
    [
        [0xFF, 0xDD], [0xFF, 0xEE], [0xFF, 0x88], [0xFF, 0x99], [0xFF, 0xAA], [0xFF, 0xBB], [0xCF, 0xDC], [0xCF, 0xEC], [0xFF, 0xFF],
        [0, 0, 1, 1], [1, 0, 1, 1], [2, 0, 0, 1], [3, 0, 0, 1], [0, 0, 0, 2], [0, 0, 2, 1],
        .. Numbers.Select(number => Little(number, sizeof(ushort))),
        .. Numbers.Select(number => Little(number, sizeof(uint))),
    ];

    private static uint[] Numbers =>
    [
        0, 1, 2, 3, 4, 20, 21, 59, 180, 186, 338, 354, 360, 946, 1_562, 1_563, 10_224, 10_225, 16_384, 25_000, 99_999, 100_000, 100_001,
        0x7F, 0x80, 0xFF, 0x100, 0x7FFF, 0x8000, 0xFFFF, 0x1_0000, 0x0400_0001, 0x3FFF_FFFF, 0x4000_0000, 0x4000_0001, 0x7F80_0000,
        0x7FC0_0000, 0x7FFF_FFFF, 0x8000_0000, 0xFF80_0000, 0xFFFF_FFFF,
    ];

    public static IReadOnlyList<byte[]> Create()
    {
        byte[][] packets =
        [
            .. ((int[])[354, 180, 360, 186, 0, 1, 7]).Select(count => Motion(DataVersion.New, count)),
            .. ((int[])[354, 180]).Select(count => Motion(DataVersion.Old, count)),
            Motion(DataVersion.Studio, 354),
            .. ((int[])[946, 338, 0, 5]).Select(Calculation),
            Command(id: 0, count: 2),
            Command(id: 4, count: 90),
            Command(id: 5, count: 1),
            Studio(59),
            Studio(2),
        ];
        byte[] noise = [.. "GET / HTTP/1.1\r\n"u8, 0xFF, 0xDD, 0xFF];
        byte[] mixed = [.. packets[1], .. noise, .. packets[8], .. packets[14], .. packets[11], .. packets[4], .. packets[3]];
        return [.. packets, mixed, noise, .. Promises()];
    }

    // Headers that announce the maximum payload, without any payload.
    private static IEnumerable<byte[]> Promises() =>
    [
        Motion(DataVersion.Old, ProtocolConstants.DefaultMaxValues)[..ProtocolConstants.HeaderSize],
        Calculation(ProtocolConstants.DefaultMaxValues)[..ProtocolConstants.HeaderSize],
        Command(id: 4, count: ProtocolConstants.MaxCommandPayload)[..ProtocolConstants.HeaderSize],
    ];

    private static byte[] Motion(DataVersion version, int count)
    {
        var header = new MotionHeader
        {
            Version = version,
            HasDisplacement = count >= 354,
            HasReference = count is 186 or 360,
            AvatarIndex = count % 3,
            AvatarName = new AvatarName(count % 2 == 0 ? "Char00" : "演员一"),
            FrameIndex = 41,
            Reserved = 1,
        };
        byte[] packet = new byte[ProtocolConstants.HeaderSize + (count * sizeof(float))];
        PacketEncoder.WriteMotion(packet, header, Values(count));
        return packet;
    }

    private static byte[] Calculation(int count)
    {
        var header = new CalculationHeader { AvatarIndex = 1, AvatarName = new AvatarName("Char01"), FrameIndex = 41 };
        byte[] packet = new byte[ProtocolConstants.HeaderSize + (count * sizeof(float))];
        PacketEncoder.WriteCalculation(packet, header, Values(count));
        return packet;
    }

    private static byte[] Command(int id, uint count)
    {
        var header = new DataCommandHeader { CommandId = (DataCommandId)id, DataCount = count };
        byte[] packet = new byte[ProtocolConstants.HeaderSize + header.PayloadSize];
        header.Write(packet);
        packet.AsSpan(ProtocolConstants.HeaderSize).Fill((byte)'H');
        return packet;
    }

    private static byte[] Studio(int bones)
    {
        byte[] payload = new byte[bones * 84];
        Values(bones * 21).CopyTo(MemoryMarshal.Cast<byte, float>(payload.AsSpan()));
        byte[] packet = new byte[ProtocolConstants.HeaderSize + payload.Length];
        PacketEncoder.WriteStudioCalculation(packet, new StudioCalculationHeader { AvatarName = new AvatarName("chr00"), FrameIndex = 41 }, payload);
        return packet;
    }

    // Position and angles of a bone, as in a stream.
    private static float[] Values(int count) => [.. Enumerable.Range(0, count).Select(index => (index * 37 % 360) - 180 + (index / 8f))];

    private static byte[] Little(uint number, int size)
    {
        byte[] bytes = new byte[sizeof(uint)];
        BinaryPrimitives.WriteUInt32LittleEndian(bytes, number);
        return bytes[..size];
    }
}
