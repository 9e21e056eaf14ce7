using System.Text;
using System.Text.Json;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Commands;

/// <summary>The answers of a command channel as one JSON object, with lengths in metres.</summary>
internal static class CommandJson
{
    public static string ZeroOut(ServerAddress server, int? avatar) => Write(json =>
    {
        json.WriteString("type"u8, "zeroOut"u8);
        json.WriteString("server"u8, server.ToString());
        if (avatar is { } number)
            json.WriteNumber("avatar"u8, number);
        else
            json.WriteString("avatar"u8, "all"u8);
    });

    public static string Report(CommandResults results) => Write(json =>
    {
        json.WriteString("type"u8, "commands"u8);
        json.WriteString("server"u8, results.Server.ToString());
        json.WriteString("rotationOrder"u8, results.Order?.ToString());
        json.WriteNumber("avatar"u8, results.Avatar);
        if (results.Sizes is { } sizes)
            WriteSizes(json, sizes);
        else
            json.WriteNull("boneSizes"u8);

        json.WriteString("bvhHeader"u8, results.Header);
    });

    private static void WriteSizes(Utf8JsonWriter json, BoneDimensions sizes)
    {
        json.WriteStartObject("boneSizes"u8);
        json.WriteNumber("head"u8, sizes.Head);
        json.WriteNumber("neck"u8, sizes.Neck);
        json.WriteNumber("body"u8, sizes.Body);
        json.WriteNumber("shoulderWidth"u8, sizes.ShoulderWidth);
        json.WriteNumber("upperArm"u8, sizes.UpperArm);
        json.WriteNumber("forearm"u8, sizes.Forearm);
        json.WriteNumber("palm"u8, sizes.Palm);
        json.WriteNumber("hipWidth"u8, sizes.HipWidth);
        json.WriteNumber("upperLeg"u8, sizes.UpperLeg);
        json.WriteNumber("lowerLeg"u8, sizes.LowerLeg);
        json.WriteNumber("heelHeight"u8, sizes.HeelHeight);
        json.WriteNumber("footLength"u8, sizes.FootLength);
        json.WriteEndObject();
    }

    private static string Write(Action<Utf8JsonWriter> write)
    {
        using var buffer = new MemoryStream();
        using (var json = new Utf8JsonWriter(buffer))
        {
            json.WriteStartObject();
            write(json);
            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(buffer.ToArray()) + "\n";
    }
}
