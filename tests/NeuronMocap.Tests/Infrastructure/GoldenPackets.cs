using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>
/// The same packet twice: written by hand from the tables of protocol.md section 2, and written by the library's encoder. Tests of the reading side
/// use the first, so that agreement between encoder and decoder is not enough.
/// </summary>
internal sealed record GoldenPacket(PacketKind Kind, byte[] ByHand, byte[] ByEncoder);

internal static class GoldenPackets
{
    public static readonly string[] Names = ["new", "studio", "old", "calculation", "command"];

    public static GoldenPacket Get(string name) => name switch
    {
        "new" => New(),
        "studio" => Studio(),
        "old" => Old(),
        "calculation" => Calculation(),
        "command" => Command(),
        _ => throw new ArgumentOutOfRangeException(nameof(name)),
    };

    /// <summary>Creates a motion packet of the New layout (section 2.1) by hand.</summary>
    public static byte[] NewMotion(
        ReadOnlySpan<float> values,
        uint avatar = 0,
        string name = "Char00",
        uint frame = 0,
        string version = "00 00 01 01",
        bool displacement = true,
        bool reference = false) =>
        new WireBytes().Hex("FF DD").Hex(version).U16(values.Length).U8(displacement ? 1 : 0).U8(reference ? 1 : 0)
            .U32(avatar).Ascii(name, 32).U32(frame).U32(0).U32(0).U32(0).Hex("FF EE")
            .Floats(values).ToArray();

    /// <summary>Creates a motion packet of the Old layout (section 2.2) by hand.</summary>
    public static byte[] OldMotion(
        ReadOnlySpan<float> values,
        uint avatar = 0,
        string name = "Char00",
        bool displacement = true,
        bool reference = false) =>
        new WireBytes().Hex("FF DD 02 00 00 01").U32((uint)values.Length).U32(displacement ? 1u : 0).U32(reference ? 1u : 0)
            .U32(avatar).Ascii(name, 32).U32(0).U32(0).Hex("FF EE")
            .Floats(values).ToArray();

    /// <summary>Creates a calculation packet (section 2.3) by hand.</summary>
    public static byte[] CalculationData(ReadOnlySpan<float> values, uint avatar = 0, string name = "Char00", uint frame = 0) =>
        new WireBytes().Hex("FF 88 03 00 00 01").U32((uint)values.Length).U32(avatar).Ascii(name, 32).U32(frame)
            .U32(0).U32(0).U32(0).Hex("FF 99")
            .Floats(values).ToArray();

    /// <summary>Creates an old command packet (section 2.6) by hand.</summary>
    public static byte[] OldCommand(int command, uint count, int payload) =>
        new WireBytes().Hex("FF AA 02 00 00 01").U32((uint)(64 + payload)).U32(count).U32((uint)command).Zeros(40).U32(0).Hex("FF BB")
            .Zeros(payload).ToArray();

    /// <summary>Creates a header of 64 bytes that announces any number of values without carrying them.</summary>
    public static byte[] HeaderAnnouncing(PacketKind kind, uint count) => kind == PacketKind.Calculation
        ? new WireBytes().Hex("FF 88 03 00 00 01").U32(count).Zeros(52).Hex("FF 99").ToArray()
        : new WireBytes().Hex("FF DD 02 00 00 01").U32(count).Zeros(52).Hex("FF EE").ToArray();

    private static GoldenPacket New() => new(
        PacketKind.Motion,
        new WireBytes()
            .Hex("FF DD  00 00 01 01  03 00  01 00  02 01 00 00")
            .Hex("43 68 61 72 30 30").Zeros(26)
            .Hex("78 56 34 12  01 00 00 00  02 00 00 00  03 00 00 80  FF EE")
            .Hex("00 00 80 3F  00 00 00 80  00 00 34 C3")
            .ToArray(),
        Motion(
            new MotionHeader
            {
                HasDisplacement = true,
                AvatarIndex = 258,
                AvatarName = new AvatarName("Char00"),
                FrameIndex = 0x12345678,
                Reserved = 1,
                Reserved1 = 2,
                Reserved2 = 0x80000003,
            },
            [1, -0f, -180]));

    private static GoldenPacket Studio() => new(
        PacketKind.Motion,
        new WireBytes()
            .Hex("FF DD  01 00 01 01  01 00  00 01  03 00 00 00")
            .Hex("E6 BC 94 E5 91 98 E4 B8 80").Zeros(23)
            .Hex("FF FF FF FF  01 00 00 00  0C 0B 0A 00  07 00 00 00  FF EE")
            .Hex("00 00 C0 7F")
            .ToArray(),
        Motion(
            new MotionHeader
            {
                Version = DataVersion.Studio,
                HasReference = true,
                AvatarIndex = 3,
                AvatarName = new AvatarName("演员一"),
                FrameIndex = uint.MaxValue,
                Reserved = 1,
                Reserved1 = 0x000A0B0C,
                Reserved2 = 7,
            },
            [BitConverter.UInt32BitsToSingle(0x7FC00000)]));

    private static GoldenPacket Old() => new(
        PacketKind.Motion,
        new WireBytes()
            .Hex("FF DD  02 00 00 01  02 00 00 00  01 00 00 00  01 00 00 00  05 00 00 00")
            .Hex("4F 6C 64").Zeros(29)
            .Hex("01 00 00 00  EF BE AD DE  FF EE")
            .Hex("00 00 00 3F  00 00 20 C1")
            .ToArray(),
        Motion(
            new MotionHeader
            {
                Version = DataVersion.Old,
                HasDisplacement = true,
                HasReference = true,
                AvatarIndex = 5,
                AvatarName = new AvatarName("Old"),
                Reserved1 = 1,
                Reserved2 = 0xDEADBEEF,
            },
            [0.5f, -10]));

    private static GoldenPacket Calculation()
    {
        var header = new CalculationHeader
        {
            AvatarIndex = 1,
            AvatarName = new AvatarName("abcdefghijklmnopqrstuvwxyz012345"),
            FrameIndex = 10,
            Reserved1 = 0x01020304,
            Reserved2 = 0x05060708,
            Reserved3 = 0x090A0B0C,
        };
        byte[] encoded = new byte[68];
        Assert.Equal(68, PacketEncoder.WriteCalculation(encoded, header, [2]));
        return new GoldenPacket(
            PacketKind.Calculation,
            new WireBytes()
                .Hex("FF 88  03 00 00 01  01 00 00 00  01 00 00 00")
                .Ascii("abcdefghijklmnopqrstuvwxyz012345", 32)
                .Hex("0A 00 00 00  04 03 02 01  08 07 06 05  0C 0B 0A 09  FF 99")
                .Hex("00 00 00 40")
                .ToArray(),
            encoded);
    }

    private static GoldenPacket Command()
    {
        byte[] encoded = new byte[64 + 5];
        new DataCommandHeader { CommandId = DataCommandId.BvhText, DataCount = 5 }.Write(encoded);
        "HIERA"u8.CopyTo(encoded.AsSpan(64));
        return new GoldenPacket(
            PacketKind.Command,
            new WireBytes()
                .Hex("FF AA  02 00 00 01  45 00 00 00  05 00 00 00  04 00 00 00").Zeros(40)
                .Hex("00 00 00 00  FF BB")
                .Ascii("HIERA", 5)
                .ToArray(),
            encoded);
    }

    private static byte[] Motion(in MotionHeader header, ReadOnlySpan<float> values)
    {
        byte[] encoded = new byte[64 + (4 * values.Length)];
        Assert.Equal(encoded.Length, PacketEncoder.WriteMotion(encoded, header, values));
        return encoded;
    }
}
