#nullable enable

using System;
using System.Collections.Generic;
using NeuronMocap.Motion;
using NeuronMocap.Retargeting;

namespace NeuronMocap.Unity.EditorTools
{
    // What the smoothing of a figure costs and brings: its delay, and the noise before and after it.
    internal static class SmoothingReport
    {
        // The speed of a quick turn, in radians per second.
        private const double QuickTurn = Math.PI;

        // The parts of a group share their settings, so any of them gives the settings of the group.
        private static readonly (string Name, BodyParts Part, BodyParts Group)[] Groups =
        {
            ("Body", BodyParts.Spine, BodyParts.Hips | BodyParts.Spine | BodyParts.Head),
            ("Arms", BodyParts.LeftArm, BodyParts.Arms),
            ("Fingers", BodyParts.LeftFingers, BodyParts.Fingers),
            ("Legs", BodyParts.LeftLeg, BodyParts.Legs),
        };

        public static IReadOnlyList<ReportRow> Of(FigureDriver driver) =>
            driver.Smoothing ? Array.ConvertAll(Groups, group => Row(driver, group.Name, group.Part, group.Group)) : Array.Empty<ReportRow>();

        private static ReportRow Row(FigureDriver driver, string name, BodyParts part, BodyParts group)
        {
            SmoothingSettings settings = driver.PartSmoothing.Get(part).ToSettings();
            string text = $"delay {PerformerRow.Number(settings.GetDelay(), "0")} ms at rest, "
                + $"{PerformerRow.Number(settings.GetDelay(QuickTurn), "0")} ms at 180 degrees/s";
            if (driver.IsDriving && driver.ActiveSmoothing is { } smoothing)
            {
                (double before, double after) = smoothing.GetNoise(group);
                text += $"; noise {PerformerRow.Number(before, "0.00")} degrees before, {PerformerRow.Number(after, "0.00")} after";
            }

            return new ReportRow($"{name} Smoothing", text);
        }
    }
}
