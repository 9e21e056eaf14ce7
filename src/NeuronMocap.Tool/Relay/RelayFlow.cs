using System.Diagnostics;
using System.Globalization;
using System.Text;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Relay.Destinations;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Watch.Live;
using NeuronMocap.Tool.Watch.Recordings;
using Spectre.Console;

namespace NeuronMocap.Tool.Relay;

/// <summary>What flows where, once a second: as a table for a terminal, or as a plain line.</summary>
internal sealed class RelayFlow(NeuronReader reader, string source, IReadOnlyList<Outlet> outlets)
{
    private const string Failed = "failed";
    private const string Dropping = "dropping";
    private const string Waiting = "waiting";

    private readonly RateMeter _received = new();
    private readonly Flow[] _flows = [.. outlets.Select(static outlet => new Flow(outlet))];

    /// <summary>Frames received per second, lately.</summary>
    public double ReceivedPerSecond => _received.PerSecond;

    /// <summary>The figures of all destinations.</summary>
    public IEnumerable<FlowFigures> Figures => _flows.Select(static flow => flow.ToFigures());

    /// <summary>Takes the figures of this moment.</summary>
    public void Update()
    {
        long now = Stopwatch.GetTimestamp();
        _received.Add(now, TakeRecorder.CountFrames(reader.GetStatistics()));
        foreach (Flow flow in _flows)
            flow.Update(now);
    }

    /// <summary>Describes a destination at the end.</summary>
    public static string Summarize(Outlet outlet)
    {
        OutletFigures figures = outlet.GetFigures();
        string bytes = figures.Bytes is { } count ? $", {Quantity.Bytes(count)}" : string.Empty;
        string failure = figures.Failure is { } reason ? $"; {DescribeFailure(reason)}" : string.Empty;
        string skipped = figures.Skipped is { } left ? Quantity.Format($", {left} left out by rate") : string.Empty;
        string note = figures is { Sent: 0, Note: { } unsent } ? $"; {unsent.Text}" : string.Empty;
        return Quantity.Format($"{outlet.Name}: {figures.Sent} {Quantity.Noun(figures.Sent, outlet.Noun)}, {figures.Dropped} dropped{skipped}{bytes}{failure}{note}");
    }

    public string ToLine(DateTime now)
    {
        var line = new StringBuilder();
        line.Append(CultureInfo.InvariantCulture, $"{now:HH:mm:ss} {source}: {DescribeSource()}, {_received.PerSecond:0.0} frames/s");
        foreach (Flow flow in _flows)
        {
            string clients = flow.Figures.Clients is { } count ? $"{count} {Quantity.Noun(count, "client")}, " : string.Empty;
            line.Append(
                CultureInfo.InvariantCulture,
                $"  {flow.Outlet.Name}: {flow.State}, {clients}{flow.PerSecond:0.0} {flow.Outlet.Unit}/s, {flow.Figures.Sent} sent, {flow.Figures.Dropped} dropped");
        }

        return line.ToString();
    }

    public Table ToTable()
    {
        ReaderStatistics statistics = reader.GetStatistics();
        var table = new Table { Border = TableBorder.Simple, UseSafeBorder = true };
        table.AddColumn("From / to");
        table.AddColumn(new TableColumn("Clients").RightAligned());
        table.AddColumn(new TableColumn("Per second").RightAligned());
        table.AddColumn(new TableColumn("Total").RightAligned());
        table.AddColumn(new TableColumn("Dropped").RightAligned());
        table.AddColumn("State");
        table.AddRow(
            Cell(source, Palette.StrongStyle),
            Cell(string.Empty),
            Cell(Quantity.Fixed(_received.PerSecond, 1)),
            Cell(Quantity.Count(TakeRecorder.CountFrames(statistics), "frame")),
            Cell(Quantity.Count(statistics.Lost)),
            Cell(DescribeSource(), new Style(Palette.Of(reader.Status.State))));
        foreach (Flow flow in _flows)
        {
            table.AddRow(
                Cell(flow.Outlet.Name),
                Cell(flow.Figures.Clients is { } clients ? Quantity.Count(clients) : string.Empty),
                Cell(Quantity.Fixed(flow.PerSecond, 1)),
                Cell(Quantity.Count(flow.Figures.Sent, flow.Outlet.Noun)),
                Cell(Quantity.Count(flow.Figures.Dropped), flow.Figures.Dropped > 0 ? Palette.WarningStyle : null),
                Cell(flow.State, flow.IsHealthy ? null : Palette.WarningStyle));
        }

        return table;
    }

    // A reason is a sentence, and a line goes on after it.
    private static string DescribeFailure(string reason) => $"failed: {reason.TrimEnd('.')}";

    private static Text Cell(string text, Style? style = null) => new(TerminalText.Clean(text), style);

    private string DescribeSource() => reader.Status is { State: ConnectionState.Receiving, Reason: ConnectionReason.None }
        ? "receiving"
        : reader.Status.Describe();

    // A destination, and how its figures change.
    private sealed class Flow(Outlet outlet)
    {
        private readonly RateMeter _sent = new();
        private readonly RateMeter _dropped = new();

        public Outlet Outlet => outlet;

        public OutletFigures Figures { get; private set; } = outlet.GetFigures();

        public double PerSecond => _sent.PerSecond;

        public bool IsHealthy => Figures.Failure is null && Figures.Note is null && _dropped.PerSecond == 0;

        public string State => this switch
        {
            { Figures.Failure: { } failure } => DescribeFailure(failure),
            { Figures.Note: { } note } => note.Text,
            { Code: Dropping } => "dropping: slow or not reachable",
            { Code: Waiting } => "waiting for clients",
            _ => Code,
        };

        private string Code => this switch
        {
            { Figures.Failure: not null } => Failed,
            { Figures.Note: { } note } => note.Code,
            { IsHealthy: false } => Dropping,
            { Figures.Clients: 0 } => Waiting,
            { PerSecond: 0 } => "idle",
            _ => "ok",
        };

        public FlowFigures ToFigures() => new(outlet.Name, outlet.Unit, Code, PerSecond, Figures.Sent, Figures.Dropped)
        {
            Clients = Figures.Clients,
            Bytes = Figures.Bytes,
            Failure = Figures.Failure,
            Skipped = Figures.Skipped,
        };

        public void Update(long now)
        {
            Figures = outlet.GetFigures();
            _sent.Add(now, Figures.Sent);
            _dropped.Add(now, Figures.Dropped);
        }
    }
}
