using System.Text.Json;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>A byte stream written by a foreign encoder, and what must come out of it.</summary>
internal sealed record StreamFixture(byte[] Bytes, IReadOnlyList<ExpectedPacket> Expected)
{
    public static StreamFixture Load(string name)
    {
        byte[] bytes = File.ReadAllBytes(Fixtures.Require("streams", name + ".bin"));
        using JsonDocument document = JsonDocument.Parse(File.ReadAllBytes(Fixtures.Require("streams", name + ".json")));
        Assert.Equal(document.RootElement.GetProperty("bytes").GetInt32(), bytes.Length);
        return new StreamFixture(bytes, [.. document.RootElement.GetProperty("expected").EnumerateArray().Select(ExpectedPacket.Parse)]);
    }
}

/// <summary>One packet of a <see cref="StreamFixture"/>; null is a field that the packet's kind or layout does not carry.</summary>
internal sealed record ExpectedPacket(
    string Type,
    string? Layout,
    int Avatar,
    string Name,
    uint? Index,
    bool? Displacement,
    bool? Reference,
    string? Version,
    uint[]? Reserved,
    float[] Values)
{
    public PacketKind Kind => Type switch
    {
        "frame" => PacketKind.Motion,
        "calculation" => PacketKind.Calculation,
        _ => PacketKind.StudioCalculation,
    };

    public static ExpectedPacket Parse(JsonElement packet) => new(
        packet.GetProperty("type").GetString()!,
        Optional(packet, "layout")?.GetString(),
        unchecked((int)packet.GetProperty("avatar").GetUInt32()),
        packet.GetProperty("name").GetString()!,
        Optional(packet, "index")?.GetUInt32(),
        Optional(packet, "displacement")?.GetBoolean(),
        Optional(packet, "reference")?.GetBoolean(),
        Optional(packet, "version")?.GetString(),
        Optional(packet, "reserved") is { } reserved ? [.. reserved.EnumerateArray().Select(field => field.GetUInt32())] : null,
        Optional(packet, "values") is { } values ? [.. values.EnumerateArray().Select(value => value.GetSingle())] : []);

    private static JsonElement? Optional(JsonElement packet, string name) =>
        packet.TryGetProperty(name, out JsonElement value) && value.ValueKind != JsonValueKind.Null ? value : null;
}
