using NeuronMocap.Calculation;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>Reads calculation exports row by row: first to measure the skeleton, then for the poses.</summary>
internal static class CalculationTakeFile
{
    private const string UsualName = "Char00";

    public static void Read(string path, TakeReading reading)
    {
        CalculationSkeleton skeleton = Measure(path, reading);
        foreach (string warning in skeleton.Warnings)
            reading.AddProblem(warning);

        PerformerWriter writer = reading.Open(new AvatarName(UsualName), default, skeleton.Body);
        using CalculationFileReader reader = CalculationFileReader.Open(path);
        if (reader.DeclaredFrameRate is null)
            reading.AddProblem("The export does not say its rate, and 120 Hz is assumed.");

        float[] values = new float[reader.ValueCount];
        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        while (reader.TryReadFrame(values))
        {
            skeleton.CopyLocalTransforms(values, pose);
            var time = TimeSpan.FromTicks((long)Math.Round((reader.FrameCount - 1) / reader.FrameRate * TimeSpan.TicksPerSecond));
            writer.Add(time, null, 0, pose, ContactsOf(values));
            reading.Report(0.5 + PartOf(reader));
        }

        foreach (CalculationRepair repair in reader.Repairs)
            reading.AddProblem($"Line {repair.Line}, column {repair.Column}: {repair.Description}");
    }

    private static CalculationSkeleton Measure(string path, TakeReading reading)
    {
        var sample = new CalculationSample();
        using CalculationFileReader reader = CalculationFileReader.Open(path);
        float[] values = new float[reader.ValueCount];
        while (reader.TryReadFrame(values))
        {
            sample.Add(values);
            reading.Report(PartOf(reader));
        }

        return sample.Measure();
    }

    private static FootContacts ContactsOf(ReadOnlySpan<float> values) =>
        new(values[CalculationFrame.BodyValueCount - 2] != 0, values[CalculationFrame.BodyValueCount - 1] != 0);

    // Half of the work.
    private static double PartOf(CalculationFileReader reader) => reader.Length is > 0 and { } length ? reader.BytesRead / (2.0 * length) : 0;
}
