using System.Diagnostics;

namespace NeuronMocap.Tool.Output;

// The lines of relay.
internal sealed partial class JsonLines
{
    /// <summary>Writes that a destination is ready, with its real address.</summary>
    public ReadOnlySpan<byte> Opened(string destination, string unit)
    {
        Begin("opened"u8);
        _json.WriteString("destination"u8, destination);
        _json.WriteString("unit"u8, unit);
        WriteTime(Stopwatch.GetTimestamp());
        return End();
    }

    /// <summary>Writes what has arrived so far.</summary>
    public ReadOnlySpan<byte> Received(ReaderStatistics statistics, double perSecond)
    {
        Begin("received"u8);
        _json.WriteNumber("frames"u8, statistics.MotionFrames);
        _json.WriteNumber("calculationFrames"u8, statistics.CalculationFrames + statistics.StudioCalculationFrames);
        _json.WriteNumber("perSecond"u8, perSecond);
        _json.WriteNumber("lost"u8, statistics.Lost);
        WriteTime(Stopwatch.GetTimestamp());
        return End();
    }

    /// <summary>Writes what has gone to a destination so far.</summary>
    public ReadOnlySpan<byte> Flow(FlowFigures figures)
    {
        Begin("flow"u8);
        WriteFlow(figures);
        _json.WriteString("state"u8, figures.State);
        _json.WriteNumber("perSecond"u8, figures.PerSecond);
        _json.WriteNumber("clients"u8, figures.Clients);
        WriteTime(Stopwatch.GetTimestamp());
        return End();
    }

    /// <summary>Writes the last line of a relay: the summary, with what has gone to each destination.</summary>
    public ReadOnlySpan<byte> Summary(ReaderStatistics statistics, IEnumerable<FlowFigures> destinations)
    {
        BeginSummary(statistics);
        _json.WriteStartArray("destinations"u8);
        foreach (FlowFigures figures in destinations)
        {
            _json.WriteStartObject();
            WriteFlow(figures);
            _json.WriteEndObject();
        }

        _json.WriteEndArray();
        return End();
    }

    private void WriteFlow(FlowFigures figures)
    {
        _json.WriteString("destination"u8, figures.Destination);
        _json.WriteString("unit"u8, figures.Unit);
        _json.WriteNumber("sent"u8, figures.Sent);
        _json.WriteNumber("dropped"u8, figures.Dropped);
        _json.WriteNumber("bytes"u8, figures.Bytes);
        _json.WriteString("failure"u8, figures.Failure);
    }
}
