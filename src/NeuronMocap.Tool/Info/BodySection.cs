using System.Text.Json.Nodes;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Info;

/// <summary>The section about the sizes of the body: centimetres in text, metres in JSON, as on the command channel.</summary>
internal static class BodySection
{
    private const float SmallestDifference = 0.05f; // cm

    private static readonly (string Name, string Label, Func<BoneDimensions, float> Get)[] Sizes =
    [
        ("head", "head", static body => body.Head),
        ("neck", "neck", static body => body.Neck),
        ("body", "body", static body => body.Body),
        ("shoulderWidth", "shoulder width", static body => body.ShoulderWidth),
        ("upperArm", "upper arm", static body => body.UpperArm),
        ("forearm", "forearm", static body => body.Forearm),
        ("palm", "palm", static body => body.Palm),
        ("hipWidth", "hip width", static body => body.HipWidth),
        ("upperLeg", "upper leg", static body => body.UpperLeg),
        ("lowerLeg", "lower leg", static body => body.LowerLeg),
        ("heelHeight", "heel height", static body => body.HeelHeight),
        ("footLength", "foot length", static body => body.FootLength),
    ];

    public static void Add(InfoReport report, MotionSource source)
    {
        InfoSection section = report.Section("boneSizes", "Body");
        BodySides sides = BodySides.Measure(source);
        foreach ((string name, string label, Func<BoneDimensions, float> get) in Sizes)
        {
            float mean = get(sides.Mean) * 100;
            float left = get(sides.Left) * 100;
            float right = get(sides.Right) * 100;
            bool differs = MathF.Abs(left - right) >= SmallestDifference;
            string text = Quantity.Format($"{mean,5:0.0} cm");
            if (differs)
                text += Quantity.Format($"   left {left:0.0}, right {right:0.0}: {MathF.Abs(left - right):0.0} apart");

            section.Add(name, label, text, Math.Round(mean / 100.0, 5));
            if (differs)
                section.Add(name + "Sides", label, null, new JsonObject { ["left"] = Math.Round(left / 100.0, 5), ["right"] = Math.Round(right / 100.0, 5) });
        }
    }
}
