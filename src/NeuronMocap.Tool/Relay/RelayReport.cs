using NeuronMocap.Server;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Relay.Destinations;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;

namespace NeuronMocap.Tool.Relay;

/// <summary>The standard output of relay: where packets go, then a live table or a plain line a second, and at the end a summary.</summary>
internal sealed class RelayReport(NeuronReader reader, string source, IReadOnlyList<Outlet> outlets, CommandRelay? commands, StandardStreams streams)
{
    private const int WidestText = 160;

    private static readonly TimeSpan Interval = TimeSpan.FromSeconds(1);

    private readonly TextPage _page = new(streams, WidestText);
    private readonly RelayFlow _flow = new(reader, source, outlets);
    private bool _isClosed;

    /// <summary>Whether the table shows the failures.</summary>
    public bool IsLive { get; } = streams.IsTerminal && Screen.IsSupported;

    /// <summary>Why the output could not be written. Null if it was written, or if its reader closed it.</summary>
    public IOException? Failure { get; private set; }

    /// <summary>Writes where packets go. Scripts wait for these lines.</summary>
    public void Announce()
    {
        WriteLine($"Relaying {source}");
        foreach (Outlet outlet in outlets)
            WriteLine(outlet.Announcement);
        if (commands?.LocalEndPoint is { } endPoint)
            WriteLine($"Commands on {endPoint}");
    }

    /// <summary>Reports until it is stopped. A closed output does not end the relay.</summary>
    public async Task RunAsync(CancellationToken cancellationToken)
    {
        _flow.Update();
        if (IsLive)
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

    /// <summary>Writes what was received and what went where.</summary>
    public void Summarize()
    {
        WriteLine(LineOutput.DescribeEnd(reader.GetStatistics()));
        foreach (Outlet outlet in outlets)
            WriteLine(RelayFlow.Summarize(outlet));
    }

    private static async Task<bool> WaitAsync(CancellationToken cancellationToken)
    {
        await Task.Delay(Interval, cancellationToken).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        return !cancellationToken.IsCancellationRequested;
    }

    private void WriteLine(string line)
    {
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
                Failure = exception;
        }
    }
}
