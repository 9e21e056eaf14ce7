#nullable enable

using System;
using System.Collections.Generic;

namespace NeuronMocap.Unity.EditorTools
{
    // The current status of a source in words. Created for each repaint, and drawn by the inspector and the window.
    internal sealed class SourceReport
    {
        private SourceReport(Severity severity, string title, string message, IReadOnlyList<ReportRow> rows, IReadOnlyList<PerformerRow> performers)
        {
            Severity = severity;
            Title = title;
            Message = message;
            Rows = rows;
            Performers = performers;
        }

        public Severity Severity { get; }

        public string Title { get; }

        // The reason and the remedy. Empty if there is no problem.
        public string Message { get; }

        public IReadOnlyList<ReportRow> Rows { get; }

        public IReadOnlyList<PerformerRow> Performers { get; }

        public static SourceReport Of(MocapSource source, bool isPlaying)
        {
            if (!source.IsOpen && !isPlaying)
                return Closed("Not open", "Sources open in play mode. Press play, or switch Preview on to see the motion now.");
            if (!source.IsOpen && !source.isActiveAndEnabled)
                return Closed("Closed", "The component or its object is disabled.");

            NeuronReader? reader = source.Reader;
            ConnectionStatus status = reader?.Status ?? default;
            Severity severity = StateTitles.SeverityOf(source.State, source.Reason);
            return new SourceReport(
                severity,
                StateTitles.Of(source.State, source.Reason),
                severity == Severity.Good ? string.Empty : source.StatusMessage,
                reader is null ? Array.Empty<ReportRow>() : RowsOf(source, status, reader.GetStatistics()),
                PerformerRow.ListOf(source));
        }

        private static SourceReport Closed(string title, string message) =>
            new SourceReport(Severity.None, title, message, Array.Empty<ReportRow>(), Array.Empty<PerformerRow>());

        private static ReportRow[] RowsOf(MocapSource source, in ConnectionStatus status, in ReaderStatistics figures)
        {
            var rows = new List<ReportRow>();
            if ((status.RemoteEndPoint ?? status.LocalEndPoint) is { } end)
                rows.Add(new ReportRow(status.RemoteEndPoint is null ? "Listening On" : "Connected To", end.ToString()));
            if (status.RetryIn is { } wait)
                rows.Add(new ReportRow("Next Attempt In", $"{PerformerRow.Number(wait.TotalSeconds, "0.0")} s (attempt {status.Attempt})", Severity.Waiting));

            bool receives = source.State == SourceState.Receiving;
            rows.Add(new ReportRow("Frame Rate", receives ? $"{PerformerRow.Number(source.FrameRate, "0.0")} /s" : "-"));
            double share = figures.MotionFrames > 0 ? (double)source.LostFrames / (source.LostFrames + figures.MotionFrames) : 0;
            rows.Add(new ReportRow(
                "Lost Frames",
                PerformerRow.Losses(source.LostFrames, figures.MotionFrames),
                source.LostFrames == 0 ? Severity.None : share > 0.01 ? Severity.Error : Severity.Warning));
            if (source.Resample && receives)
                AddDelay(rows, source);

            rows.Add(new ReportRow("Frames", PerformerRow.Number(figures.MotionFrames, "#,0")));
            if (figures.Reconnects > 0)
                rows.Add(new ReportRow("Reconnects", PerformerRow.Number(figures.Reconnects, "0"), Severity.Warning));
            if (figures.BytesSkipped > 0)
                rows.Add(new ReportRow("Bytes Outside Packets", PerformerRow.Number(figures.BytesSkipped, "#,0"), Severity.Warning));
            if (figures.RefusedDatagrams > 0)
                rows.Add(new ReportRow("Refused Datagrams", PerformerRow.Number(figures.RefusedDatagrams, "#,0"), Severity.Warning));
            if (FormatName(status.Format) is { } format)
                rows.Add(new ReportRow("Format", format, status.Format == StreamFormat.Text ? Severity.Warning : Severity.None));

            return rows.ToArray();
        }

        // A stream needs its delay when frames are uneven. A shorter delay shows as late frames.
        private static void AddDelay(List<ReportRow> rows, MocapSource source)
        {
            float needed = 0;
            long late = 0;
            foreach (Performer performer in source.Performers)
            {
                needed = Math.Max(needed, performer.IsLive ? performer.NeededDelay * 1000 : 0);
                late += performer.LateFrames;
            }

            rows.Add(new ReportRow(
                "Delay",
                $"{PerformerRow.Number(source.Delay, "0")} ms; the stream needs {PerformerRow.Number(needed, "0")} ms",
                needed > source.Delay ? Severity.Warning : Severity.None));
            rows.Add(new ReportRow("Late Frames", PerformerRow.Number(late, "#,0")));
        }

        private static string? FormatName(StreamFormat format) => format switch
        {
            StreamFormat.Binary => "binary",
            StreamFormat.OldHeader => "binary, old header: lost frames cannot be detected",
            StreamFormat.Text => "text: lost frames cannot be detected, and numbers take more bytes",
            StreamFormat.Studio => "binary, from Axis Studio",
            _ => null,
        };
    }
}
