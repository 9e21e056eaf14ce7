using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Relay.Destinations;
using NeuronMocap.Tool.Simulate;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Watch;
using NeuronMocap.Tool.Watch.Playback;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.Relay;

/// <summary>One relay, from the options to its end. It ends with its source, its duration or a request of the user.</summary>
internal sealed class RelayRun(RelayOptions options, StandardStreams streams)
{
    // A file is paced, but a busy computer may stop this process for a while.
    private const int FileQueueCapacity = 8192;

    private readonly FailureMessage _failure = new();
    private string? _commandFailure;

    public async Task<int> RunAsync(CancellationToken cancellationToken)
    {
        try
        {
            using Broadcaster? own = await Task.Run(OpenOwnSource, CancellationToken.None).WaitAsync(cancellationToken);
            ServerAddress? server = own is null ? options.Connection.Server : ServerAddress.Of(own.LocalEndPoint!);
            return await RunAsync(server, cancellationToken);
        }
        catch (Exception exception) when (exception is BroadcasterException or PlayException or RelayException)
        {
            return await FailAsync(OptionNames.Translate(exception.Message));
        }
        catch (OperationCanceledException) when (cancellationToken.IsCancellationRequested)
        {
            return ToolCommand.Done;
        }
    }

    // The demo and a file are broadcast inside this process. Both begin when the reader connects, so it gets everything.
    private Broadcaster? OpenOwnSource()
    {
        if (options.Source.Kind == SourceKind.Demo)
            return Broadcaster.StartDemo();
        if (options.Play is not { } play)
            return null;

        // Says what is wrong with the file.
        play.Open(order: null).Dispose();
        var broadcaster = new Broadcaster(new BroadcasterOptions
        {
            RecordingPath = play.File,
            RecordingSpeed = play.Speed,
            LoopRecording = play.Loop,
            FrameRate = play.FrameRate,
            QueueCapacity = FileQueueCapacity,
            Port = 0,
            WaitForClient = true,
        });
        broadcaster.Start();
        return broadcaster;
    }

    private async Task<int> RunAsync(ServerAddress? server, CancellationToken cancellationToken)
    {
        bool isOnce = options.Connection.Once || options.Play is not null;
        await using var reader = new NeuronReader((options.Connection with { Once = isOnce }).ToReaderOptions(server));
        var outlets = new List<Outlet>();
        try
        {
            foreach (Destination destination in options.Destinations)
                outlets.Add(destination.Open(reader, options.Overwrite));

            await using CommandRelay? commands = OpenCommands();
            return await RunAsync(reader, outlets, commands, cancellationToken);
        }
        finally
        {
            foreach (Outlet outlet in outlets)
                await outlet.DisposeAsync();
        }
    }

    private async Task<int> RunAsync(NeuronReader reader, IReadOnlyList<Outlet> outlets, CommandRelay? commands, CancellationToken cancellationToken)
    {
        RelayOutput output = CreateOutput(reader, outlets, commands?.LocalEndPoint);
        reader.StatusChanged += _failure.OnStatus;
        reader.StatusChanged += output.OnStatus;
        reader.EventReported += news =>
        {
            if (FileFailure.Of(news) is { } failed && !output.OnFileFailed(failed))
                streams.Complain(failed.Text);
        };
        output.Announce();

        using var durationSource = new CancellationTokenSource(options.Connection.Duration ?? Timeout.InfiniteTimeSpan);
        using var stopSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken, durationSource.Token);
        reader.Start();
        Task reporting = output.RunAsync(stopSource.Token);
        await Task.WhenAny(reporting, reader.Completion);
        bool asked = cancellationToken.IsCancellationRequested;
        ConnectionStatus status = reader.Status;

        await reader.DisposeAsync();
        await stopSource.CancelAsync();
        await reporting;
        bool[] complete = await Task.WhenAll(outlets.Select(outlet => outlet.FinishAsync(streams)));
        await output.FinishAsync();
        if (output.Failure is { } failure)
            return await FailAsync(FileFault.OfStandardOutput(failure));
        if (complete.Contains(value: false))
            return ToolCommand.NothingReceived;

        ReaderStatistics statistics = reader.GetStatistics();
        return asked || TakeRecorder.CountFrames(statistics) > 0 ? ToolCommand.Done : await FailAsync(_failure.Describe(status, statistics));
    }

    private RelayOutput CreateOutput(NeuronReader reader, IReadOnlyList<Outlet> outlets, IPEndPoint? commands)
    {
        string source = options.Source.ToString();
        return options.Output == OutputKind.Person
            ? new RelayReport(reader, source, outlets, commands, streams)
            : new RelayJson(reader, source, outlets, commands, streams.Output, isQuiet: options.Output == OutputKind.Quiet);
    }

    private CommandRelay? OpenCommands()
    {
        if (options.Commands is not { } place)
            return null;

        var relay = new CommandRelay(new CommandRelayOptions
        {
            Host = options.Connection.Server!.Value.Host,
            HostPort = options.Connection.CommandPort ?? ProtocolConstants.DefaultCommandPort,
            BindAddress = place.EndPoint.Address,
            Port = place.EndPoint.Port,
        });
        relay.Failed += OnCommandFailed;
        try
        {
            relay.Start();
            return relay;
        }
        catch (BroadcasterException exception)
        {
            throw new RelayException($"--commands {StartFailure.DescribeArgument(exception, place.Text, place.EndPoint)}");
        }
    }

    // Clients try again and again. The same reason is said once.
    private void OnCommandFailed(Exception exception)
    {
        if (!string.Equals(Interlocked.Exchange(ref _commandFailure, exception.Message), exception.Message, StringComparison.Ordinal))
            streams.Complain($"--commands: {exception.Message}");
    }

    private async Task<int> FailAsync(string message)
    {
        await streams.ComplainAsync(message);
        return ToolCommand.NothingReceived;
    }
}
