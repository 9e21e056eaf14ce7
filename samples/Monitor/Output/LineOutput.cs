using System.Globalization;
using System.Text;
using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Monitor.Output;

/// <summary>For a log file or a pipe: one plain line a second.</summary>
internal sealed class LineOutput(NeuronReader reader, Stream output) : MonitorOutput
{
    private static readonly TimeSpan Period = TimeSpan.FromSeconds(1);

    private bool _broken;

    public override async Task RunAsync(CancellationToken stop)
    {
        using var timer = new PeriodicTimer(Period);
        try
        {
            while (!_broken && await timer.WaitForNextTickAsync(stop))
                WriteLine(Describe(reader.Status, reader.GetStatistics(), reader.GetAvatarStatistics()));
        }
        catch (OperationCanceledException)
        {
            // Stopped between two lines.
        }
    }

    public override void Finish(ReaderStatistics statistics) => WriteLine(DescribeEnd(statistics));

    public static string DescribeEnd(ReaderStatistics statistics) => string.Create(
        CultureInfo.InvariantCulture,
        $"{statistics.MotionFrames} motion and {statistics.CalculationFrames + statistics.StudioCalculationFrames} calculation frames in {statistics.Duration.TotalSeconds:0.0} s; "
        + $"lost {statistics.Lost}, dropped {statistics.Dropped}, skipped {statistics.SkippedBytes} bytes.");

    private static string Describe(ConnectionStatus status, ReaderStatistics statistics, IEnumerable<AvatarStatistics> avatars)
    {
        var line = new StringBuilder();
        line.Append(CultureInfo.InvariantCulture, $"{DateTime.Now:HH:mm:ss} {status.State}");
        if (status.State != ConnectionState.Receiving)
            line.Append(CultureInfo.InvariantCulture, $": {TerminalText.Clean(status.Message)}");

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
            line.Append(CultureInfo.InvariantCulture, $"  {(uint)avatar.AvatarIndex} {name} {kind} {avatar.Rate:0.0} Hz{reduction} {avatar.Frames} frames");
        }

        return line
            .Append(CultureInfo.InvariantCulture, $"  lost {statistics.Lost} dropped {statistics.Dropped} skipped {statistics.SkippedBytes} bytes")
            .ToString();
    }

    private void WriteLine(string line)
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
