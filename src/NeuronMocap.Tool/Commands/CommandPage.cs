using System.Globalization;
using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Commands;

/// <summary>The answers of a command channel as readable text.</summary>
internal sealed class CommandPage(StandardStreams streams)
{
    private const int WidestText = 110;

    private readonly TextPage _page = new(streams, WidestText);

    public void ZeroOut(ServerAddress server, int? avatar) => _page.WriteLine(avatar is null
        ? $"All avatars of {server} were zeroed out."
        : Quantity.Format($"Avatar {avatar} of {server} was zeroed out."));

    /// <summary>Writes all results, each with a title.</summary>
    public void Report(CommandResults results)
    {
        _page.WriteLine($"Command channel of {results.Server}", Palette.StrongStyle);
        if (results.Order is { } order)
        {
            _page.WriteLine();
            _page.WriteLine($"Rotation order     {order}");
        }

        if (results.Sizes is { } sizes)
            WriteSizes(results.Avatar, sizes);
        if (results.Header is { } header)
            WriteHeader(results, header);
    }

    private void WriteSizes(int avatar, BoneDimensions sizes)
    {
        WriteTitle(Quantity.Format($"Bone sizes of avatar {avatar}, in metres"));
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
            _page.WriteRow(string.Empty, 0, Quantity.Format($"{left[i].Name,-16} {left[i].Value,6:0.000}    {right[i].Name,-12} {right[i].Value,6:0.000}"));
    }

    private void WriteHeader(CommandResults results, string header)
    {
        WriteTitle(Quantity.Format($"BVH header of avatar {results.Avatar}, {header.Length:N0} characters"));
        foreach (string line in Describe(BvhDocument.Parse(Encoding.UTF8.GetBytes(header)), results.Order))
            _page.WriteRow(string.Empty, 0, line);
    }

    private void WriteTitle(string title)
    {
        _page.WriteLine();
        _page.WriteLine(title, Palette.StrongStyle);
    }

    private static IEnumerable<string> Describe(BvhDocument document, RotationOrder? order)
    {
        BvhJoint root = document.Joints[0];
        yield return string.Create(
            CultureInfo.InvariantCulture,
            $"{document.Joints.Count} {Quantity.Noun(document.Joints.Count, "joint")} from {TerminalText.Clean(root.Name)}, {document.ChannelCount} {Quantity.Noun(document.ChannelCount, "value")} a frame");
        if (!BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out string? reason))
        {
            yield return $"not the 59 bones of Axis Neuron: {TerminalText.Clean(reason)}";
            yield break;
        }

        yield return $"displacement {OnOff(map.Layout.HasDisplacement)}, reference {OnOff(map.Layout.HasReference)}, bone names {map.Format.Variant}";
        yield return order is null || map.Format.RotationOrder == order
            ? $"rotation order {map.Format.RotationOrder}"
            : $"rotation order {map.Format.RotationOrder}, but the server reports {order}";
        yield return string.Create(CultureInfo.InvariantCulture, $"hips {map[Bone.Hips].Offset.Y:0.0} cm above the ground");
    }

    private static string OnOff(bool value) => value ? "on" : "off";
}
