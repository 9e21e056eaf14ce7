using System.Numerics;
using System.Text.Json.Nodes;
using NeuronMocap.Tool.Figures;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Info;

/// <summary>The section about the root motion of the body.</summary>
internal static class MotionSection
{
    public static void Add(InfoReport report, PointMotion motion, TakeCurves curves)
    {
        InfoSection section = report.Section("walk", motion.IsInCentimetres ? "Walk" : "Root motion");
        (double unit, string name) = motion.IsInCentimetres ? (0.01, "m") : (1, "units of the file");
        Vector3 size = curves.Highest - curves.Lowest;
        if (!SampledPose.IsFinite(size))
            return;

        section.Add(
            "extent",
            "extent",
            Quantity.Format($"{size.X * unit:0.00} by {size.Z * unit:0.00} {name}: X {Plain(curves.Lowest.X * unit):0.00} to {Plain(curves.Highest.X * unit):0.00}, ")
                + Quantity.Format($"Z {Plain(curves.Lowest.Z * unit):0.00} to {Plain(curves.Highest.Z * unit):0.00}"),
            Box(curves, unit));
        section.Add(
            "hips",
            motion.IsInCentimetres ? "hips" : "height",
            Quantity.Format($"{curves.Lowest.Y * unit:0.00} to {curves.Highest.Y * unit:0.00} {name} high"),
            new JsonObject { ["lowest"] = Math.Round(curves.Lowest.Y * unit, 5), ["highest"] = Math.Round(curves.Highest.Y * unit, 5) });
        section.Add("distance", "distance walked", Quantity.Format($"{curves.Distance * unit:0.00} {name}"), curves.Distance * unit);
        section.Add(
            "meanSpeed",
            "speed",
            Quantity.Format($"mean {curves.Distance * unit / motion.Duration:0.00} {name}/s, at most {Known(curves.Root.Highest) * unit:0.00} {name}/s"),
            curves.Distance * unit / motion.Duration);
        section.Add("highestSpeed", string.Empty, null, Known(curves.Root.Highest) * unit);
        AddFeet(section, motion, curves, unit, name);
    }

    private static void AddFeet(InfoSection section, PointMotion motion, TakeCurves curves, double unit, string name)
    {
        if (!motion.Roles.HasFeet)
            return;

        section.Add("ground", "ground", Quantity.Format($"{Plain(curves.Ground * unit):0.000} {name}: the lowest position of a foot"), curves.Ground * unit);
        if (curves.LeftContacts is not { } left || curves.RightContacts is not { } right)
            return;

        section.Add(
            "footContacts",
            "feet on ground",
            Quantity.Format($"left {left.Share * 100:0.0} %, right {right.Share * 100:0.0} % of the time; {left.Steps.Count} and {right.Steps.Count} {Quantity.Noun(right.Steps.Count, "time")} set down"),
            new JsonObject
            {
                ["left"] = Math.Round(left.Share, 5),
                ["right"] = Math.Round(right.Share, 5),
                ["leftSteps"] = left.Steps.Count,
                ["rightSteps"] = right.Steps.Count,
            });
    }

    // Avoids a minus sign before zero.
    private static double Plain(double value) => Math.Abs(value) < 0.005 && Math.Round(value, 3) == 0 ? 0 : value;

    private static double Known(float speed) => float.IsFinite(speed) ? speed : 0;

    private static JsonObject Box(TakeCurves curves, double unit) => new()
    {
        ["lowestX"] = Math.Round(curves.Lowest.X * unit, 5),
        ["highestX"] = Math.Round(curves.Highest.X * unit, 5),
        ["lowestZ"] = Math.Round(curves.Lowest.Z * unit, 5),
        ["highestZ"] = Math.Round(curves.Highest.Z * unit, 5),
    };
}
