using System.Globalization;
using System.Text;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Output;

/// <summary>Writes one plain line a second, for a log file or a pipe.</summary>
internal sealed class LineOutput(NeuronReader reader, Stream output) : WatchOutput
{
    private static readonly TimeSpan Period = TimeSpan.FromSeconds(1);

    private readonly Lock _lock = new();
    private readonly Dictionary<int, Timecode?> _timecodes = [];
    private volatile bool _broken;

    public override async Task RunAsync(CancellationToken cancellationToken)
    {
        using LatestFrames latest = reader.OpenLatest();
        using var timer = new PeriodicTimer(Period);
        try
        {
            while (!_broken && await timer.WaitForNextTickAsync(cancellationToken))
            {
                IReadOnlyList<AvatarStatistics> avatars = reader.GetAvatarStatistics();
                TakeTimecodes(latest, avatars);
                WriteLine(Describe(reader.Status, reader.GetStatistics(), avatars));
            }
        }
        catch (OperationCanceledException)
        {
            // Stopped between two lines.
        }
    }

    public override bool OnFileFailed(FileFailure failure)
    {
        WriteLine(string.Create(CultureInfo.InvariantCulture, $"{DateTime.Now:HH:mm:ss} {failure.Text}"));
        return true;
    }

    public override void Finish(ReaderStatistics statistics) => WriteLine(DescribeEnd(statistics));

    public static string DescribeEnd(ReaderStatistics statistics) => string.Create(
        CultureInfo.InvariantCulture,
        $"{statistics.MotionFrames} motion and {statistics.CalculationFrames + statistics.StudioCalculationFrames} calculation {Quantity.Noun(statistics.CalculationFrames + statistics.StudioCalculationFrames, "frame")} in {statistics.Duration.TotalSeconds:0.0} s; "
        + $"lost {statistics.Lost}, dropped {statistics.Dropped}, skipped {statistics.BytesSkipped} {Quantity.Noun(statistics.BytesSkipped, "byte")}{DescribeRejected(statistics, ", ")}.");

    private static string DescribeRejected(ReaderStatistics statistics, string separator) => statistics.RejectedMessages > 0
        ? string.Create(CultureInfo.InvariantCulture, $"{separator}rejected {statistics.RejectedMessages} {Quantity.Noun(statistics.RejectedMessages, "message")}")
        : string.Empty;

    // If a server stops sending timecodes, the next line has none.
    private void TakeTimecodes(LatestFrames latest, IReadOnlyList<AvatarStatistics> avatars)
    {
        foreach (AvatarStatistics avatar in avatars)
        {
            bool isMotion = avatar.Kind == PacketKind.Motion && (uint)avatar.AvatarIndex < LatestFrames.MaxAvatars;
            if (isMotion && latest.TryTakeMotion(avatar.AvatarIndex, out MotionFrame? frame))
                _timecodes[avatar.AvatarIndex] = frame.Timecode;
        }
    }

    internal string Describe(ConnectionStatus status, ReaderStatistics statistics, IEnumerable<AvatarStatistics> avatars)
    {
        var line = new StringBuilder();
        line.Append(CultureInfo.InvariantCulture, $"{DateTime.Now:HH:mm:ss} {status.State}");
        if (status.State != ConnectionState.Receiving || status.Reason != ConnectionReason.None)
            line.Append(CultureInfo.InvariantCulture, $": {status.Describe()}");

        foreach (AvatarStatistics avatar in avatars)
        {
            string kind = avatar.Kind switch
            {
                PacketKind.Motion => "motion",
                PacketKind.Calculation => "calculation",
                _ => "studio calculation",
            };
            string name = TerminalText.Clean(avatar.AvatarName);
            string reduction = avatar.FrequencyReduction > 1 ? $" (1 of {avatar.FrequencyReduction} frames)" : string.Empty;
            line.Append(CultureInfo.InvariantCulture, $"  {(uint)avatar.AvatarIndex} {name} {kind} {avatar.FrameRate:0.0} Hz{reduction} {avatar.Frames} {Quantity.Noun(avatar.Frames, "frame")}{TimecodeOf(avatar)}");
        }

        string buffer = status.ReceiveBufferSize is { } size
            ? string.Create(CultureInfo.InvariantCulture, $" buffer {size} of {status.RequestedReceiveBufferSize} bytes")
            : string.Empty;
        return line
            .Append(CultureInfo.InvariantCulture, $"  lost {statistics.Lost} dropped {statistics.Dropped} skipped {statistics.BytesSkipped} {Quantity.Noun(statistics.BytesSkipped, "byte")}{DescribeRejected(statistics, " ")}{buffer}")
            .ToString();
    }

    private string TimecodeOf(AvatarStatistics avatar) =>
        avatar.Kind == PacketKind.Motion && _timecodes.GetValueOrDefault(avatar.AvatarIndex) is { } timecode ? $" timecode {timecode}" : string.Empty;

    // Lines come from the timer and from the thread that reports a failure.
    private void WriteLine(string line)
    {
        lock (_lock)
        {
            try
            {
                output.Write(Encoding.UTF8.GetBytes(line + "\n"));
                output.Flush();
            }
            catch (IOException exception)
            {
                OnWriteFailed(exception);
                _broken = true;
            }
        }
    }
}
