using NeuronMocap.Recording;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Watch.Export;
using NeuronMocap.Tool.Watch.Live;
using NeuronMocap.Tool.Watch.Playback;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.Watch;

/// <summary>One run of the program, with a reader and an output. It ends with its stream, its limit, a failure or a request of the user.</summary>
internal sealed class WatchRun(WatchOptions options, StandardStreams streams)
{
    private readonly TaskCompletionSource<ReaderStatistics> _limitReached = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly FailureMessage _failure = new();
    private long _frames;

    public async Task<int> RunAsync(CancellationToken cancellationToken)
    {
        try
        {
            using RecordingPlayer? player = await OpenAsync(options.Play, cancellationToken);
            using Broadcaster? demo = options.IsDemo ? Broadcaster.StartDemo(rotationOrder: options.Connection.RotationOrder ?? RotationOrder.YXZ) : null;
            return await RunAsync(demo is null ? options.Connection.Server : ServerAddress.Of(demo.LocalEndPoint!), player, cancellationToken);
        }
        catch (Exception exception) when (exception is BroadcasterException or ExportException or PlayException)
        {
            return await FailAsync(OptionNames.Translate(exception.Message));
        }
        catch (OperationCanceledException) when (cancellationToken.IsCancellationRequested)
        {
            return ToolCommand.Done;
        }
    }

    // A large file of bytes without times is read once when it is opened.
    private async Task<RecordingPlayer?> OpenAsync(PlaySettings? play, CancellationToken cancellationToken) => play is null
        ? null
        : await Task.Run(() => play.Open(options.Connection.RotationOrder), CancellationToken.None).WaitAsync(cancellationToken);

    private async Task<int> RunAsync(ServerAddress? server, RecordingPlayer? player, CancellationToken cancellationToken)
    {
        NeuronReaderOptions readerOptions = options.Connection.ToReaderOptions(server);
        await using NeuronReader reader = player is null ? new NeuronReader(readerOptions) : new NeuronReader(player, readerOptions);
        using ExportRun export = ExportRun.Begin(reader, options.Export, options.Frames);
        var takes = new TakeRecorder(reader, options.Recording);
        if (!takes.TryBegin(out string? error))
            return await FailAsync(error!);

        WatchOutput output = CreateOutput(reader, player, takes);
        Connect(reader, output);

        using var durationSource = new CancellationTokenSource(options.Connection.Duration ?? Timeout.InfiniteTimeSpan);
        using var stopSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken, durationSource.Token);
        reader.Start();
        Task showing = output.RunAsync(stopSource.Token);
        await Task.WhenAny(showing, reader.Completion, _limitReached.Task, NothingToDoAsync(export, takes));
        bool asked = !durationSource.IsCancellationRequested && !reader.Completion.IsCompleted;
        ConnectionStatus status = reader.Status;

        await reader.DisposeAsync();
        await stopSource.CancelAsync();
        await showing;

        // At the last requested frame, the receive thread took the statistics. Later frames do not count.
        ReaderStatistics statistics = _limitReached.Task.IsCompleted ? await _limitReached.Task : reader.GetStatistics();
        output.Finish(statistics);
        bool isExported = export.TryFinish(streams);
        bool isRecorded = await takes.FinishAsync(streams);
        if (output.Failure is { } failure)
            return await FailAsync(FileFault.OfStandardOutput(failure));
        if (!isExported || !isRecorded)
            return ToolCommand.NothingReceived;

        // The lines of --json contain it.
        if (options.Output != OutputKind.Json && _failure.DescribeReceiving() is { } doubt)
            await streams.ComplainAsync(doubt);
        if (asked || TakeRecorder.CountFrames(statistics) > 0)
            return ToolCommand.Done;

        return await FailAsync(_failure.Describe(status, statistics));
    }

    private async Task<int> FailAsync(string message)
    {
        await streams.ComplainAsync(message);
        return ToolCommand.NothingReceived;
    }

    private WatchOutput CreateOutput(NeuronReader reader, RecordingPlayer? player, TakeRecorder takes) => options.Output switch
    {
        OutputKind.Json => new JsonOutput(streams.Output, options.Source),
        OutputKind.Quiet => new QuietOutput(streams.Output),
        _ when streams.IsTerminal && Screen.IsSupported => new LiveOutput(reader, player, takes, options.Connection, streams.Output),
        _ => new LineOutput(reader, streams.Output),
    };

    // Ends a run without output when no file is left to write. Other outputs go on when a file fails.
    private Task NothingToDoAsync(ExportRun export, TakeRecorder takes)
    {
        Task?[] files = [export.Broken, takes.Broken];
        return options.Output == OutputKind.Quiet && files.OfType<Task>().ToArray() is { Length: > 0 } asked
            ? Task.WhenAll(asked)
            : Task.Delay(Timeout.Infinite);
    }

    private void Connect(NeuronReader reader, WatchOutput output)
    {
        reader.EventReported += news =>
        {
            if (FileFailure.Of(news) is { } failed && !output.OnFileFailed(failed))
                streams.Complain(failed.Text);
        };
        reader.StatusChanged += _failure.OnStatus;
        reader.StatusChanged += output.OnStatus;
        reader.MotionReceived += frame =>
        {
            if (_limitReached.Task.IsCompleted)
                return;

            output.OnMotion(frame);
            Count(reader);
        };
        reader.CalculationReceived += frame =>
        {
            if (_limitReached.Task.IsCompleted)
                return;

            output.OnCalculation(frame);
            Count(reader);
        };
        reader.StudioCalculationReceived += frame =>
        {
            if (_limitReached.Task.IsCompleted)
                return;

            output.OnStudioCalculation(frame);
            Count(reader);
        };
    }

    // Runs on the receive thread, so the statistics do not change meanwhile.
    private void Count(NeuronReader reader)
    {
        if (++_frames == options.Frames)
            _limitReached.TrySetResult(reader.GetStatistics());
    }
}
