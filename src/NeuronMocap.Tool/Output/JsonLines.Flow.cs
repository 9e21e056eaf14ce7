using System.Diagnostics;
using NeuronMocap.Json;

namespace NeuronMocap.Tool.Output;

// The lines of relay.
internal sealed partial class JsonLines
{
    /// <summary>Writes that a destination is ready, with its real address.</summary>
    public ReadOnlySpan<byte> Opened(string destination, string unit)
    {
        Begin("opened"u8);
        Json.WriteString("destination"u8, destination);
        Json.WriteString("unit"u8, unit);
        WriteTime(Stopwatch.GetTimestamp());
        return End();
    }

    /// <summary>Writes what has arrived so far.</summary>
    public ReadOnlySpan<byte> Received(ReaderStatistics statistics, double perSecond)
    {
        Begin("received"u8);
        Json.WriteNumber("frames"u8, statistics.MotionFrames);
        Json.WriteNumber("calculationFrames"u8, statistics.CalculationFrames + statistics.StudioCalculationFrames);
        Json.WriteNumber("perSecond"u8, perSecond);
        Json.WriteNumber("lost"u8, statistics.Lost);
        WriteTime(Stopwatch.GetTimestamp());
        return End();
    }

    /// <summary>Writes what has gone to a destination so far.</summary>
    public ReadOnlySpan<byte> Flow(FlowFigures figures)
    {
        Begin("flow"u8);
        WriteFlow(figures);
        Json.WriteString("state"u8, figures.State);
        Json.WriteNumber("perSecond"u8, figures.PerSecond);
        Json.WriteNumber("clients"u8, figures.Clients);
        WriteTime(Stopwatch.GetTimestamp());
        Json.WriteNumber("skipped"u8, figures.Skipped);
        return End();
    }

    /// <summary>Writes the last line of a relay: the summary, with what has gone to each destination.</summary>
    public ReadOnlySpan<byte> Summary(ReaderStatistics statistics, IEnumerable<FlowFigures> destinations)
    {
        BeginSummary(statistics);
        Json.WriteStartArray("destinations"u8);
        foreach (FlowFigures figures in destinations)
        {
            Json.WriteStartObject();
            WriteFlow(figures);
            Json.WriteNumber("skipped"u8, figures.Skipped);
            Json.WriteEndObject();
        }

        Json.WriteEndArray();
        return End();
    }

    private void WriteFlow(FlowFigures figures)
    {
        Json.WriteString("destination"u8, figures.Destination);
        Json.WriteString("unit"u8, figures.Unit);
        Json.WriteNumber("sent"u8, figures.Sent);
        Json.WriteNumber("dropped"u8, figures.Dropped);
        Json.WriteNumber("bytes"u8, figures.Bytes);
        Json.WriteString("failure"u8, figures.Failure);
    }
}
