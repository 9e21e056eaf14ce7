using System.Globalization;
using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Commands;

/// <summary>The answers of a command channel for a person.</summary>
internal static class CommandText
{
    public static string ZeroOut(ServerAddress server, ZeroOutTarget target) => target.Avatar is { } avatar
        ? $"Avatar {avatar} of {server} was zeroed out.\n"
        : $"All avatars of {server} were zeroed out.\n";

    public static string Report(ServerAddress server, int avatar, RotationOrder order, BoneDimensions sizes, string header)
    {
        var text = new StringBuilder();
        text.Append(CultureInfo.InvariantCulture, $"Command channel of {server}\n\n");
        text.Append(CultureInfo.InvariantCulture, $"Rotation order     {order}\n\n");
        text.Append(CultureInfo.InvariantCulture, $"Bone sizes of avatar {avatar}, in metres\n");
        (string Name, float Value)[] left =
        [
            ("head", sizes.Head), ("neck", sizes.Neck), ("body", sizes.Body), ("shoulder width", sizes.ShoulderWidth),
            ("upper arm", sizes.UpperArm), ("forearm", sizes.Forearm),
        ];
        (string Name, float Value)[] right =
        [
            ("palm", sizes.Palm), ("hip width", sizes.HipWidth), ("upper leg", sizes.UpperLeg), ("lower leg", sizes.LowerLeg),
            ("heel height", sizes.HeelHeight), ("foot length", sizes.FootLength),
        ];
        for (int i = 0; i < left.Length; i++)
        {
            text.Append(
                CultureInfo.InvariantCulture,
                $"  {left[i].Name,-16} {left[i].Value,6:0.000}    {right[i].Name,-12} {right[i].Value,6:0.000}\n");
        }

        text.Append(CultureInfo.InvariantCulture, $"\nBVH header of avatar {avatar}, {header.Length:N0} characters\n");
        foreach (string line in Describe(BvhDocument.Parse(Encoding.UTF8.GetBytes(header)), order))
            text.Append(CultureInfo.InvariantCulture, $"  {line}\n");

        return text.ToString();
    }

    private static IEnumerable<string> Describe(BvhDocument document, RotationOrder order)
    {
        BvhJoint root = document.Joints[0];
        yield return string.Create(
            CultureInfo.InvariantCulture,
            $"{document.Joints.Count} joints from {TerminalText.Clean(root.Name)}, {document.ChannelCount} values a frame");
        if (!BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out string? reason))
        {
            yield return $"not the 59 bones of Axis Neuron: {TerminalText.Clean(reason)}";
            yield break;
        }

        yield return $"displacement {OnOff(map.Layout.HasDisplacement)}, reference {OnOff(map.Layout.HasReference)}, bone names {map.Format.Variant}";
        yield return map.Format.RotationOrder == order
            ? $"rotation order {map.Format.RotationOrder}"
            : $"rotation order {map.Format.RotationOrder}, which is not the {order} that the server says it has";
        yield return string.Create(CultureInfo.InvariantCulture, $"hips {map[Bone.Hips].Offset.Y:0.0} cm above the ground");
    }

    private static string OnOff(bool value) => value ? "on" : "off";
}
