using System.Net;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Relay.Destinations;

namespace NeuronMocap.Tool.Relay;

/// <summary>--json: a line for the source and for each destination a second, and one for each event. --quiet: only the summary.</summary>
internal sealed class RelayJson : RelayOutput
{
    // A program that still reads takes the rest at once.
    private static readonly TimeSpan FinishTimeout = TimeSpan.FromSeconds(2);

    private readonly Lock _lock = new();
    private readonly JsonLines _lines = new();
    private readonly NeuronReader _reader;
    private readonly RelayFlow _flow;
    private readonly IReadOnlyList<Outlet> _outlets;
    private readonly IPEndPoint? _commands;
    private readonly bool _isQuiet;
    private readonly LineQueue _queue;

    /// <summary>Writes the first line, unless the output is quiet. Times count from here.</summary>
    public RelayJson(NeuronReader reader, string source, IReadOnlyList<Outlet> outlets, IPEndPoint? commands, Stream output, bool isQuiet)
    {
        (_reader, _outlets, _commands, _isQuiet) = (reader, outlets, commands, isQuiet);
        _flow = new RelayFlow(reader, source, outlets);
        _queue = new LineQueue(output);
        if (!isQuiet)
            _queue.Add(_lines.Start(source));
    }

    public override IOException? Failure => _queue.Failure;

    public override void Announce()
    {
        if (_isQuiet)
            return;

        lock (_lock)
        {
            foreach (Outlet outlet in _outlets)
                _queue.Add(_lines.Opened(outlet.Name, outlet.Unit));
            if (_commands is not null)
                _queue.Add(_lines.Opened($"{TcpDestination.Scheme}{_commands}", "commands"));
        }
    }

    public override void OnStatus(ConnectionStatus status)
    {
        if (_isQuiet)
            return;

        lock (_lock)
            _queue.Add(_lines.Status(status));
    }

    public override bool OnFileFailed(FileFailure failure)
    {
        if (_isQuiet)
            return false;

        lock (_lock)
            _queue.Add(_lines.FileFailed(failure));

        return true;
    }

    public override async Task RunAsync(CancellationToken cancellationToken)
    {
        _flow.Update();
        while (await WaitAsync(cancellationToken))
        {
            _flow.Update();
            if (_isQuiet)
                continue;

            lock (_lock)
            {
                _queue.Add(_lines.Received(_reader.GetStatistics(), _flow.ReceivedPerSecond));
                foreach (FlowFigures figures in _flow.Figures)
                    _queue.Add(_lines.Flow(figures));
            }
        }
    }

    public override Task FinishAsync()
    {
        _flow.Update();
        byte[] summary;
        lock (_lock)
            summary = _lines.Summary(_reader.GetStatistics(), _flow.Figures).ToArray();

        return _queue.FinishAsync(summary, FinishTimeout);
    }
}
