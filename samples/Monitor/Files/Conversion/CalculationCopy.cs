using System.Text;
using NeuronMocap.Calculation;
using NeuronMocap.Frames;
using NeuronMocap.Monitor.Terminal;
using NeuronMocap.Playback;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Sources;

namespace NeuronMocap.Monitor.Files.Conversion;

/// <summary>Rows of calculation data, copied value by value.</summary>
internal static class CalculationCopy
{
    private const int LongestEnd = 64;

    /// <summary>From an export to another one.</summary>
    public static void ToFile(FileSettings settings, TimeRange range, string output, IProgress<double> progress, CancellationToken cancelled)
    {
        using CalculationFileReader reader = CalculationFileReader.Open(settings.Input, settings.Calculation);
        CalculationTextFormat format = range.IsAll ? reader.TextFormat with { LastRowEnd = ReadEnd(settings.Input) } : reader.TextFormat;
        using var writer = new CalculationFileWriter(output, reader.ValueCount, format);
        Copy(reader, range, (_, values) => writer.WriteFrame(values), progress, cancelled);
    }

    /// <summary>From an export to the packets of a stream; the sink is closed.</summary>
    public static void ToPackets(FileSettings settings, TimeRange range, IPacketSink sink, IProgress<double> progress, CancellationToken cancelled)
    {
        using (sink)
        using (CalculationFileReader reader = CalculationFileReader.Open(settings.Input, settings.Calculation))
        {
            var header = new CalculationHeader { ValueCount = reader.ValueCount, AvatarName = new AvatarName("Char00") };
            byte[] packet = new byte[header.PacketSize];
            Copy(reader, range, Send, progress, cancelled);

            void Send(long row, ReadOnlySpan<float> values)
            {
                int length = PacketEncoder.WriteCalculation(packet, header with { FrameIndex = (uint)row }, values);
                sink.Write(FrameTimes.Of(row, reader.FrameRate), packet.AsSpan(0, length));
            }
        }
    }

    /// <summary>From the calculation frames of a stream to an export, one row for each.</summary>
    /// <returns>False when the stream has none of the avatar, and nothing was written.</returns>
    public static bool TryFromStream(FileSettings settings, TimeRange range, string output, IProgress<double> progress, CancellationToken cancelled)
    {
        using RecordedFrameReader reader = RecordedFrameReader.Open(settings.Input, settings.Playback);
        CalculationFileWriter? writer = null;
        int? avatar = settings.Avatar;
        try
        {
            while (reader.Read())
            {
                cancelled.ThrowIfCancellationRequested();
                progress.Report(reader.Duration > TimeSpan.Zero ? reader.Time / reader.Duration : 0);
                if (reader.Frame is not CalculationFrame { BoneCount: > 0 } frame || frame.AvatarIndex != (avatar ?? frame.AvatarIndex))
                    continue;

                avatar = frame.AvatarIndex;
                if (!range.Contains(reader.Time))
                    continue;

                writer ??= new CalculationFileWriter(output, frame.Values.Length);
                if (frame.Values.Length == writer.ValueCount)
                    writer.WriteFrame(frame.Values);
            }
        }
        finally
        {
            writer?.Dispose();
        }

        return writer is not null;
    }

    /// <summary>The calculation frames of an avatar whose stream has no poses; null where there are poses, or no calculation frames.</summary>
    public static (CalculationDocument Document, string AvatarName)? TryLoadStream(FileSettings settings, IProgress<double> progress, CancellationToken cancelled)
    {
        using RecordedFrameReader reader = RecordedFrameReader.Open(settings.Input, settings.Playback);
        using var text = new MemoryStream();
        CalculationFileWriter? writer = null;
        (int? avatar, string name, TimeSpan first, TimeSpan last) = (settings.Avatar, string.Empty, TimeSpan.Zero, TimeSpan.Zero);
        while (reader.Read())
        {
            cancelled.ThrowIfCancellationRequested();
            progress.Report(reader.Duration > TimeSpan.Zero ? reader.Time / reader.Duration : 0);
            if (reader.Frame.AvatarIndex != (avatar ?? reader.Frame.AvatarIndex))
                continue;
            if (reader.Frame is MotionFrame { HasSkeleton: true })
                return null;
            if (reader.Frame is not CalculationFrame { BoneCount: > 0 } frame)
                continue;

            if (writer is null)
                (writer, first, name) = (new CalculationFileWriter(text, frame.Values.Length, leaveOpen: true), reader.Time, frame.AvatarName);
            if (frame.Values.Length != writer.ValueCount)
                continue;

            (avatar, last) = (frame.AvatarIndex, reader.Time);
            writer.WriteFrame(frame.Values);
        }

        if (writer is null)
            return null;

        writer.Dispose();
        double rate = settings.InputRate
            ?? (last > first ? RecordingSource.ChooseRate((writer.FrameCount - 1) / (last - first).TotalSeconds) : CalculationReadOptions.DefaultFrameRate);
        return (CalculationDocument.Parse(text.GetBuffer().AsSpan(0, (int)text.Length), new CalculationReadOptions { FrameRate = rate }), name);
    }

    // What stands behind the last value, which a writer has to know before it comes there.
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
        CalculationFileReader reader, TimeRange range, Action<long, ReadOnlySpan<float>> write, IProgress<double> progress, CancellationToken cancelled)
    {
        (long first, long count) = range.FramesOf(long.MaxValue / 2, reader.FrameRate);
        float[] values = new float[reader.ValueCount];
        long rows = 0;
        for (; rows < first + count && reader.TryReadFrame(values); rows++)
        {
            cancelled.ThrowIfCancellationRequested();
            if (rows >= first)
                write(rows - first, values);
            if (reader.Length is > 0 and { } length)
                progress.Report((double)reader.BytesRead / length);
        }

        if (rows <= first)
            throw new NeuronException(Quantity.Format($"Nothing is left: the take ends at {rows / reader.FrameRate:0.###} s."));
    }
}
