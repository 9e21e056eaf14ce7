using System.Text.Json;

namespace NeuronMocap.Data.Tests.Streams;

/// <summary>The streams of shared/data, written by a foreign encoder, with their expected results.</summary>
internal static class ForeignStreams
{
    public static StreamFixture Load(string name)
    {
        byte[] bytes = File.ReadAllBytes(Fixtures.Require("streams", name + ".bin"));
        using JsonDocument document = JsonDocument.Parse(File.ReadAllBytes(Fixtures.Require("streams", name + ".json")));
        Assert.Equal(document.RootElement.GetProperty("bytes").GetInt32(), bytes.Length);
        return new StreamFixture(bytes, [.. document.RootElement.GetProperty("expected").EnumerateArray().Select(Parse)]);
    }

    private static ExpectedPacket Parse(JsonElement packet) => new(
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
