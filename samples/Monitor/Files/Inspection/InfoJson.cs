using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace NeuronMocap.Monitor.Files.Inspection;

/// <summary>A report for a program: one JSON object in one line.</summary>
internal static class InfoJson
{
    private static readonly JsonSerializerOptions Options = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    public static string Write(InfoReport report)
    {
        var json = new JsonObject { ["type"] = "info", ["file"] = report.File, ["kind"] = report.Kind };
        foreach (InfoSection section in report.Sections)
            json[section.Name] = section.Facts.Count == 0 ? Items(section) : Facts(section);

        return json.ToJsonString(Options) + "\n";
    }

    private static JsonObject Facts(InfoSection section)
    {
        var json = new JsonObject();
        foreach (InfoFact fact in section.Facts.Where(static fact => fact.Name.Length > 0))
            json[fact.Name] = fact.Value?.DeepClone();

        return json;
    }

    private static JsonArray Items(InfoSection section) => [.. section.Items.Select(static item => item.Json.DeepClone())];
}
