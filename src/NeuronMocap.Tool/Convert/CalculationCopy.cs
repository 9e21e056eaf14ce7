using System.Text;
using NeuronMocap.Calculation;
using NeuronMocap.Protocol;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Convert;

/// <summary>Copies rows of calculation data value by value.</summary>
internal static class CalculationCopy
{
    private const int LongestEnd = 64;

    /// <summary>Copies an export to another export.</summary>
    public static void ToFile(
        FileSettings settings, TimeRange range, string output, ConversionSummary summary, IProgress<double> progress, CancellationToken cancellationToken)
    {
        using CalculationFileReader reader = CalculationFileReader.Open(settings.Input, settings.Calculation);
        CalculationTextFormat format = range.IsAll ? reader.TextFormat with { LastRowEnd = ReadEnd(settings.Input) } : reader.TextFormat;
        if (settings.InputRate is { } rate)
            format = format.WithFrameRate(rate);

        using var writer = new CalculationFileWriter(output, reader.ValueCount, format);
        Copy(reader, range, (_, values) => writer.WriteFrame(values), summary, progress, cancellationToken);
    }

    /// <summary>Converts an export to the packets of a stream. Closes the sink.</summary>
    public static void ToPackets(
        FileSettings settings, TimeRange range, IPacketSink sink, ConversionSummary summary, IProgress<double> progress, CancellationToken cancellationToken)
    {
        using (sink)
        using (CalculationFileReader reader = CalculationFileReader.Open(settings.Input, settings.Calculation))
        {
            var header = new CalculationHeader { ValueCount = reader.ValueCount, AvatarName = new AvatarName("Char00") };
            byte[] packet = new byte[header.PacketSize];
            Copy(reader, range, Send, summary, progress, cancellationToken);

            void Send(long row, ReadOnlySpan<float> values)
            {
                int length = PacketEncoder.WriteCalculation(packet, header with { FrameIndex = (uint)row }, values);
                sink.Write(FrameTimes.Of(row, reader.FrameRate), packet.AsSpan(0, length));
            }
        }
    }

    // Reads the text after the last value. A writer needs it before it reaches the end.
    private static string ReadEnd(string path)
    {
        using FileStream file = File.OpenRead(path);
        byte[] end = new byte[(int)Math.Min(file.Length, LongestEnd)];
        file.Position = file.Length - end.Length;
        file.ReadExactly(end);
        string text = Encoding.ASCII.GetString(end);
        return text[text.TrimEnd().Length..];
    }

    private static void Copy(
        CalculationFileReader reader,
        TimeRange range,
        Action<long, ReadOnlySpan<float>> write,
        ConversionSummary summary,
        IProgress<double> progress,
        CancellationToken cancellationToken)
    {
        (long first, long count) = range.FramesOf(long.MaxValue / 2, reader.FrameRate);
        float[] values = new float[reader.ValueCount];
        long rows = 0;
        for (; rows < first + count && reader.TryReadFrame(values); rows++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            if (rows >= first)
                write(rows - first, values);
            if (reader.Length is > 0 and { } length)
                progress.Report((double)reader.BytesRead / length);
        }

        summary.AddRepairs(reader.Repairs, reader.RepairCount, reader.SkippedRowCount);
        if (reader is { DeclaredFrameRate: null, FrameRate: CalculationReadOptions.DefaultFrameRate })
            summary.AddWarning("the export does not say its rate, and 120 Hz is assumed; set --rate if it differs");

        (summary.Frames, summary.FrameRate, summary.Seconds) = (rows - first, reader.FrameRate, (rows - first) / reader.FrameRate);
        if (rows <= first)
            throw new NeuronException(Quantity.Format($"No frames remain: the take ends at {rows / reader.FrameRate:0.###} s."));
    }
}
