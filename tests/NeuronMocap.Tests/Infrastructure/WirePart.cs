namespace NeuronMocap.Tests.Infrastructure;

/// <summary>The kinds of headers. Those of commands differ in what determines their length.</summary>
internal enum WireShape
{
    NewMotion,
    OldMotion,
    Calculation,
    CommandWithoutPayload,
    CommandWithBoneSizes,
    CommandWithText,
    StudioCalculation,
}

/// <summary>Specifies the content of payloads and noise.</summary>
internal enum Filling
{
    Zeros,
    Numbers,

    /// <summary>First and second tokens of every kind, some of them 62 bytes apart.</summary>
    Tokens,

    /// <summary>Whole small packets, one after the other.</summary>
    Packets,
}

/// <summary>A part of a generated stream. Its text shows how to create the same bytes again.</summary>
internal abstract record WirePart
{
    public abstract byte[] ToBytes();

    /// <summary>Returns simpler parts, for shrinking.</summary>
    public virtual IEnumerable<WirePart> Simpler() => [];

    protected static byte[] Header(WireShape shape, uint count, uint avatar = 0, string version = "00 00 01 01") => shape switch
    {
        WireShape.NewMotion => new WireBytes().Hex("FF DD").Hex(version).U16((int)(count & 0xFFFF)).U8(1).U8(0)
            .U32(avatar).Ascii("Char00", 32).U32(7).Zeros(12).Hex("FF EE").ToArray(),
        WireShape.OldMotion => new WireBytes().Hex("FF DD 02 00 00 01").U32(count).U32(0).U32(1)
            .U32(avatar).Ascii("Char00", 32).Zeros(8).Hex("FF EE").ToArray(),
        WireShape.Calculation => new WireBytes().Hex("FF 88 03 00 00 01").U32(count)
            .U32(avatar).Ascii("Char00", 32).U32(7).Zeros(12).Hex("FF 99").ToArray(),
        WireShape.StudioCalculation => new WireBytes().Hex("CF DC 00 00 00 02").U32(4 * count)
            .U32(avatar).Ascii("Char00", 32).U32(7).U32(0).U32(0xFE).Zeros(4).Hex("CF EC").ToArray(),
        _ => new WireBytes().Hex("FF AA 02 00 00 01").U32(64).U32(count).U32(CommandOf(shape)).Zeros(40).U32(0).Hex("FF BB").ToArray(),
    };

    protected static byte[] Fill(Filling filling, int length)
    {
        byte[] pattern = filling switch
        {
            Filling.Numbers => [.. Enumerable.Range(1, 251).Select(number => (byte)number)],
            Filling.Tokens => Convert.FromHexString("FFDDFFEEFF88FF99FFAAFFBBFFFFDD00FFCFDCCFECCFFF0A30"),
            Filling.Packets => [.. Header(WireShape.NewMotion, 1), 1, 2, 3, 4, .. Header(WireShape.Calculation, 0)],
            _ => [0],
        };
        byte[] bytes = new byte[length];
        for (int i = 0; i < length; i++)
            bytes[i] = pattern[i % pattern.Length];

        return bytes;
    }

    private static uint CommandOf(WireShape shape) => shape switch
    {
        WireShape.CommandWithBoneSizes => 0,
        WireShape.CommandWithText => 4,
        _ => 3,
    };
}

/// <summary>A packet with the payload that its header announces.</summary>
internal sealed record Packet(WireShape Shape, int Count, Filling Filling, uint Avatar) : WirePart
{
    public override byte[] ToBytes() => [.. Header(Shape, (uint)Count, Avatar), .. Fill(Filling, PayloadSize)];

    public override IEnumerable<WirePart> Simpler() =>
    [
        .. Properties.SimplerNumbers(Count).Select(count => this with { Count = count }),
        .. Filling == Filling.Zeros ? (IEnumerable<WirePart>)[] : [this with { Filling = Filling.Zeros }],
        .. Avatar == 0 ? (IEnumerable<WirePart>)[] : [this with { Avatar = 0 }],
    ];

    // Not a property, because it would be printed with each case.
    public bool IsAllowed() => Count <= WireStream.MaxValues
        || Shape is WireShape.CommandWithoutPayload or WireShape.CommandWithBoneSizes or WireShape.CommandWithText;

    private int PayloadSize => Shape switch
    {
        WireShape.CommandWithoutPayload => 0,
        WireShape.CommandWithBoneSizes => 64 * Count,
        WireShape.CommandWithText => Count,
        _ => 4 * Count,
    };
}

/// <summary>A header whose payload differs from what it announces.</summary>
internal sealed record Promise(WireShape Shape, uint Count, int Payload, Filling Filling) : WirePart
{
    public override byte[] ToBytes() => [.. Header(Shape, Count), .. Fill(Filling, Payload)];

    public override IEnumerable<WirePart> Simpler() =>
    [
        .. Properties.SimplerNumbers(Payload).Select(payload => this with { Payload = payload }),
        .. Filling == Filling.Zeros ? (IEnumerable<WirePart>)[] : [this with { Filling = Filling.Zeros }],
    ];
}

/// <summary>A motion packet of any version.</summary>
internal sealed record OfVersion(byte Major, byte Minor, byte Revision, byte Build, int Count) : WirePart
{
    public override byte[] ToBytes() =>
        [.. Header(WireShape.NewMotion, (uint)Count, version: $"{Build:X2} {Revision:X2} {Minor:X2} {Major:X2}"), .. Fill(Filling.Numbers, 4 * Count)];

    public override IEnumerable<WirePart> Simpler() => Properties.SimplerNumbers(Count).Select(count => this with { Count = count });
}

/// <summary>The first token of one kind and the second token of the same or another kind, at any distance. In a header, the distance is 62.</summary>
internal sealed record TokenPair(PacketKind First, PacketKind Second, int Distance, int Behind) : WirePart
{
    public override byte[] ToBytes()
    {
        byte[] second = Second switch
        {
            PacketKind.Motion => [0xFF, 0xEE],
            PacketKind.Calculation => [0xFF, 0x99],
            PacketKind.Command => [0xFF, 0xBB],
            _ => [0xCF, 0xEC],
        };
        byte[] first = First switch
        {
            PacketKind.Motion => [0xFF, 0xDD],
            PacketKind.Calculation => [0xFF, 0x88],
            PacketKind.Command => [0xFF, 0xAA],
            _ => [0xCF, 0xDC],
        };
        byte[] bytes = new byte[Distance + 2 + Behind];
        second.CopyTo(bytes, Distance);
        first.CopyTo(bytes, 0);
        return bytes;
    }

    public override IEnumerable<WirePart> Simpler() => Properties.SimplerNumbers(Behind).Select(behind => this with { Behind = behind });
}

/// <summary>A section of another part: a packet whose start was missed, or whose end never came.</summary>
internal sealed record Stretch(WirePart Of, int Skipped, int Length) : WirePart
{
    public override byte[] ToBytes()
    {
        byte[] bytes = Of.ToBytes();
        int start = Math.Min(Skipped, bytes.Length);
        return bytes[start..Math.Min(start + Length, bytes.Length)];
    }

    public override IEnumerable<WirePart> Simpler() =>
    [
        Of,
        .. Properties.SimplerNumbers(Length).Select(length => this with { Length = length }),
        .. Properties.SimplerNumbers(Skipped).Select(skipped => this with { Skipped = skipped }),
    ];
}

/// <summary>A part with one changed byte.</summary>
internal sealed record Damaged(WirePart Of, int At, byte Byte) : WirePart
{
    public override byte[] ToBytes()
    {
        byte[] bytes = Of.ToBytes();
        if (At < bytes.Length)
            bytes[At] = Byte;

        return bytes;
    }

    public override IEnumerable<WirePart> Simpler() => [Of, .. Of.Simpler().Select(simpler => this with { Of = simpler })];
}

/// <summary>Bytes that are not a packet, or look like several.</summary>
internal sealed record Noise(Filling Filling, int Length) : WirePart
{
    public override byte[] ToBytes() => Fill(Filling, Length);

    public override IEnumerable<WirePart> Simpler() => Properties.SimplerNumbers(Length).Select(length => this with { Length = length });
}
