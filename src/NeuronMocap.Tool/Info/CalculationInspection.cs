using System.Text.Json.Nodes;
using NeuronMocap.Calculation;
using NeuronMocap.Server;
using NeuronMocap.Tool.Figures;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Info;

/// <summary>The report of info about a calculation export.</summary>
internal sealed class CalculationInspection(FileSettings settings, IProgress<double> progress)
{
    private const int LeftContact = CalculationFrame.BodyValueCount - 2;

    public InfoReport Run(CancellationToken cancellationToken)
    {
        using CalculationFileReader reader = CalculationFileReader.Open(settings.Input, settings.Calculation);
        int bones = reader.ValueCount == CalculationFrame.FullValueCount ? 59 : 21;
        var report = new InfoReport(
            Path.GetFileName(settings.Input), "calculation", $"Calculation export of {bones} bones, {Quantity.Bytes(reader.Length ?? 0)}");
        InfoSection take = report.Section("take", "Take");
        InfoSection oddities = report.Section("oddities", "Oddities");
        (long left, long right) = Scan(reader, oddities, cancellationToken);

        double duration = reader.FrameCount / reader.FrameRate;
        take.Add("bytes", string.Empty, null, reader.Length ?? 0);
        take.Add("seconds", "duration", Quantity.Format($"{duration:0.000} s"), duration);
        take.Add("frames", "frames", Quantity.Count(reader.FrameCount), reader.FrameCount);
        take.Add("frameRate", "frame rate", DescribeFrameRate(reader), reader.FrameRate);
        take.Add("columns", "columns", Quantity.Format($"{reader.ValueCount}: 16 for each of {bones} bones, and the contacts of both feet"), reader.ValueCount);
        take.Add("decimals", "text", Describe(reader.TextFormat), reader.TextFormat.Decimals);
        take.Add(
            "footContacts",
            "feet on ground",
            Quantity.Format($"left {100.0 * left / reader.FrameCount:0.0} %, right {100.0 * right / reader.FrameCount:0.0} % of the frames, as the server measured"),
            new JsonObject { ["left"] = Math.Round((double)left / reader.FrameCount, 5), ["right"] = Math.Round((double)right / reader.FrameCount, 5) });
        if (reader.InitialDirection is { } direction)
        {
            take.Add(
                "initialDirection",
                "faces at start",
                Quantity.Format($"{direction.X:0.####} {direction.Y:0.####} {direction.Z:0.####} in the file's axes: Zd of its header"),
                new JsonArray(direction.X, direction.Y, direction.Z));
        }

        AddPoses(report, oddities, cancellationToken);
        if (oddities.IsEmpty)
            oddities.Remark("none", "none");

        return report;
    }

    private void AddPoses(InfoReport report, InfoSection oddities, CancellationToken cancellationToken)
    {
        try
        {
            var source = new CalculationSource(CalculationDocument.Load(settings.Input, settings.ReadCalculation(progress, cancellationToken)));
            foreach (string warning in source.Skeleton.Warnings)
                oddities.Remark("lengths", warning);

            BodySection.Add(report, source);
            var motion = new BodyMotion(source);
            MotionSection.Add(report, motion, TakeCurves.Measure(motion, progress, cancellationToken));
        }
        catch (CalculationFormatException exception)
        {
            oddities.Remark("noPoses", exception.Message);
        }
    }

    private string DescribeFrameRate(CalculationFileReader reader)
    {
        string rate = Quantity.Format($"{reader.FrameRate:0.###} Hz");
        if (settings.InputRate is not null)
            return rate + ": as --rate says";

        return rate + (reader.DeclaredFrameRate is null ? ", assumed: the export does not say; --rate sets another one" : ": as the header of the file says");
    }

    private static string Describe(CalculationTextFormat format) => string.Create(
        System.Globalization.CultureInfo.InvariantCulture,
        $"{Quantity.Count(format.Decimals, "decimal")}, {(format.Separator is "\t" ? "tabs" : "blanks")} between them, {(format.Header.Length > 0 ? $"{Quantity.Count(format.Header.Length, "byte")} before the rows" : "no header")}");

    private (long Left, long Right) Scan(CalculationFileReader reader, InfoSection oddities, CancellationToken cancellationToken)
    {
        float[] values = new float[reader.ValueCount];
        float[] first = new float[reader.ValueCount];
        bool[] changes = new bool[reader.ValueCount];
        (long left, long right, long notNumbers) = (0, 0, 0);
        while (reader.TryReadFrame(values))
        {
            cancellationToken.ThrowIfCancellationRequested();
            progress.Report(reader.Length is > 0 and { } length ? (double)reader.BytesRead / length : 0);
            left += values[LeftContact] != 0 ? 1 : 0;
            right += values[LeftContact + 1] != 0 ? 1 : 0;
            if (reader.FrameCount == 1)
                values.CopyTo(first, 0);

            for (int i = 0; i < values.Length; i++)
            {
                changes[i] |= values[i] != first[i];
                notNumbers += float.IsFinite(values[i]) ? 0 : 1;
            }
        }

        foreach (CalculationRepair repair in reader.Repairs)
            oddities.Remark("repair", repair.Description, repair.Line, repair.Column);
        if (reader.RepairCount > reader.Repairs.Count)
            oddities.Remark("repairs", $"{reader.RepairCount - reader.Repairs.Count} more {Quantity.Noun(reader.RepairCount - reader.Repairs.Count, "repair")}");
        if (notNumbers > 0)
            oddities.Remark("notNumbers", Quantity.Count(notNumbers, "value is not a finite number", "values are not finite numbers"));
        if (changes.Count(static changes => !changes) is > 0 and var constant)
            oddities.Remark("constantColumns", $"{constant} of the {values.Length} values never {Quantity.Noun(constant, "changes", "change")}");

        return (left, right);
    }
}
