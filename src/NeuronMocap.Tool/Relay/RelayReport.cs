using System.Net;
using System.Text;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Relay.Destinations;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;

namespace NeuronMocap.Tool.Relay;

/// <summary>The standard output of relay: where packets go, then a live table or a plain line a second, and at the end a summary.</summary>
internal sealed class RelayReport(NeuronReader reader, string source, IReadOnlyList<Outlet> outlets, IPEndPoint? commands, StandardStreams streams)
    : RelayOutput
{
    private const int WidestText = 160;

    // A program that still reads takes the rest at once.
    private static readonly TimeSpan FinishTimeout = TimeSpan.FromSeconds(2);

    // Null for a terminal.
    private readonly LineQueue? _queue = streams.IsTerminal ? null : new LineQueue(streams.Output);

    // The table shows the failures.
    private readonly bool _isLive = streams.IsTerminal && Screen.IsSupported;

    private readonly TextPage _page = new(streams, WidestText);
    private readonly RelayFlow _flow = new(reader, source, outlets);
    private bool _isClosed;
    private IOException? _failure;

    public override IOException? Failure => _queue is null ? _failure : _queue.Failure;

    // Scripts wait for these lines.
    public override void Announce()
    {
        WriteLine($"Relaying {source}");
        foreach (Outlet outlet in outlets)
            WriteLine(outlet.Announcement);
        if (commands is not null)
            WriteLine($"Commands on {commands}");
    }

    public override bool OnFileFailed(FileFailure failure) => _isLive;

    public override async Task RunAsync(CancellationToken cancellationToken)
    {
        _flow.Update();
        if (_isLive)
        {
            await _page.Console.Live(_flow.ToTable()).AutoClear(enabled: true).StartAsync(async view =>
            {
                while (await WaitAsync(cancellationToken))
                {
                    _flow.Update();
                    view.UpdateTarget(_flow.ToTable());
                }
            });
            return;
        }

        while (await WaitAsync(cancellationToken))
        {
            _flow.Update();
            WriteLine(_flow.ToLine(DateTime.Now));
        }
    }

    public override async Task FinishAsync()
    {
        string[] lines = [LineOutput.DescribeEnd(reader.GetStatistics()), .. outlets.Select(RelayFlow.Summarize)];
        if (_queue is null)
            Array.ForEach(lines, WriteLine);
        else
            await _queue.FinishAsync([.. lines.SelectMany(Encode)], FinishTimeout);
    }

    private static byte[] Encode(string line) => Encoding.UTF8.GetBytes(TerminalText.Clean(line) + "\n");

    private void WriteLine(string line)
    {
        if (_queue is not null)
        {
            _queue.Add(Encode(line));
            return;
        }

        if (_isClosed)
            return;

        try
        {
            _page.WriteLine(line);
        }
        catch (IOException exception)
        {
            _isClosed = true;
            if (!StandardStreams.IsBrokenPipe(exception))
                _failure = exception;
        }
    }
}
