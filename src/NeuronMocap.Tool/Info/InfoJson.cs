using System.Text.Json;
using System.Text.Json.Nodes;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Info;

/// <summary>A report as one JSON object in one line.</summary>
internal static class InfoJson
{
    private static readonly JsonSerializerOptions Options = new() { Encoder = TerminalText.JsonEncoder };

    public static string Write(InfoReport report)
    {
        var json = new JsonObject { ["type"] = "info", ["file"] = report.File, ["kind"] = report.Kind };
        foreach (InfoSection section in report.Sections)
            json[section.Name] = section.Facts.Count == 0 ? Items(section) : Facts(section);

        return json.ToJsonString(Options) + "\n";
    }

    /// <summary>The object of a file that cannot be read.</summary>
    public static string WriteFault(string file, string sentence) =>
        new JsonObject { ["type"] = "info", ["file"] = file, ["error"] = sentence }.ToJsonString(Options) + "\n";

    private static JsonObject Facts(InfoSection section)
    {
        var json = new JsonObject();
        foreach (InfoFact fact in section.Facts.Where(static fact => fact.Name.Length > 0))
            json[fact.Name] = Finite(fact.Value);

        return json;
    }

    private static JsonArray Items(InfoSection section) => [.. section.Items.Select(static item => Finite(item.Json))];

    // Copies a node and replaces values that are not finite numbers by null. JSON cannot express them.
    private static JsonNode? Finite(JsonNode? node) => node switch
    {
        JsonObject json => new JsonObject(json.Select(static member => KeyValuePair.Create(member.Key, Finite(member.Value)))),
        JsonArray list => new JsonArray([.. list.Select(Finite)]),
        JsonValue value when value.TryGetValue(out double number) && !double.IsFinite(number) => null,
        JsonValue value when value.TryGetValue(out float number) && !float.IsFinite(number) => null,
        _ => node?.DeepClone(),
    };
}
