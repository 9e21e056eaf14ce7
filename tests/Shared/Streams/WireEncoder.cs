using System.Globalization;
using System.Text;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>
/// Writes streams field by field, from the tables of protocol.md section 2, and keeps the expected result of each packet. It shares no code with the
/// library.
/// </summary>
internal sealed class WireEncoder
{
    private readonly List<byte> _bytes = [];
    private readonly List<ExpectedPacket> _expected = [];

    public StreamFixture ToFixture() => new([.. _bytes], _expected);

    /// <summary>A motion packet of the New layout (section 2.1).</summary>
    public WireEncoder New(
        float[] values,
        uint index,
        int avatar = 0,
        string name = "Char00",
        bool displacement = false,
        bool reference = false,
        string version = "1.1.0.0",
        uint[]? reserved = null)
    {
        reserved ??= [0, 0, 0];
        _expected.Add(new("frame", "new", avatar, name, index, displacement, reference, version, reserved, values));
        return Raw(NewHeader(values.Length, index, avatar, name, displacement, reference, version, reserved).Floats(values));
    }

    /// <summary>A motion packet of the New layout without values, which no consumer receives.</summary>
    public WireEncoder NewWithoutValues() => Raw(NewHeader(0, 1, 0, "Char00", displacement: true, reference: false, "1.1.0.0", [0, 0, 0]));

    /// <summary>A motion packet of the Old layout (section 2.2).</summary>
    public WireEncoder Old(float[] values, int avatar, string name)
    {
        _expected.Add(new("frame", "old", avatar, name, null, true, false, "1.0.0.2", [0, 0], values));
        return Raw(new WireBytes().Hex("FF DD 02 00 00 01").U32((uint)values.Length).U32(1).U32(0)
            .U32((uint)avatar).Bytes(Encoding.UTF8.GetBytes(name), 32).U32(0).U32(0).Hex("FF EE").Floats(values));
    }

    /// <summary>A line of the text stream with two decimals for each value (section 2.5). A reader receives the rounded values.</summary>
    public WireEncoder Line(float[] values, int avatar, string name)
    {
        string[] words = [.. values.Select(static value => value.ToString("F2", CultureInfo.InvariantCulture))];
        _expected.Add(new("frame", "text", avatar, name, null, null, null, null, null, [.. words.Select(static word => float.Parse(word, CultureInfo.InvariantCulture))]));
        return Raw(Encoding.UTF8.GetBytes($"{avatar} {name} {string.Join(' ', words)} ||\r\n"));
    }

    /// <summary>A calculation packet (section 2.3).</summary>
    public WireEncoder Calculation(float[] values, uint index, int avatar)
    {
        _expected.Add(new("calculation", null, avatar, "Char00", index, null, null, null, null, values));
        return Raw(new WireBytes().Hex("FF 88 03 00 00 01").U32((uint)values.Length).U32((uint)avatar).Ascii("Char00", 32).U32(index)
            .U32(0).U32(0).U32(0).Hex("FF 99").Floats(values));
    }

    /// <summary>A calculation packet of Axis Studio (section 2.4): field f of bone b is b + f/32, and bone 4 has lost its sensor.</summary>
    public WireEncoder StudioCalculation(int bones, uint index)
    {
        var packet = new WireBytes().Hex("CF DC 00 00 00 02").U32((uint)(bones * 84)).U32(0).Ascii("chr00", 32).U32(index).U32(0).U32(0xFE).U32(0).Hex("CF EC");
        for (int bone = 0; bone < bones; bone++)
            packet.Floats([.. Enumerable.Range(0, 20).Select(field => bone + (field / 32f))]).U32(bone == 4 ? 1u : 0);

        _expected.Add(new("studioCalculation", null, 0, "chr00", index, null, null, null, null, []));
        return Raw(packet);
    }

    /// <summary>An old command packet (section 2.6), which is not a frame.</summary>
    public WireEncoder Command() => Raw(new WireBytes().Hex("FF AA 02 00 00 01").U32(64).U32(0).U32(2).Zeros(40).U32(0).Hex("FF BB"));

    public WireEncoder Raw(WireBytes bytes) => Raw(bytes.ToArray());

    public WireEncoder Raw(byte[] bytes)
    {
        _bytes.AddRange(bytes);
        return this;
    }

    private static WireBytes NewHeader(int count, uint index, int avatar, string name, bool displacement, bool reference, string version, uint[] reserved)
    {
        byte[] numbers = [.. version.Split('.').Select(static number => byte.Parse(number, CultureInfo.InvariantCulture)).Reverse()];
        return new WireBytes().Hex("FF DD").Bytes(numbers, 4).U16(count).U8(displacement ? 1 : 0).U8(reference ? 1 : 0)
            .U32((uint)avatar).Bytes(Encoding.UTF8.GetBytes(name), 32).U32(index).U32(reserved[0]).U32(reserved[1]).U32(reserved[2]).Hex("FF EE");
    }
}
