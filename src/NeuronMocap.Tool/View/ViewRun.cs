using System.Net;
using System.Reflection;
using NeuronMocap.Files;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Simulate;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.View.Actions;
using NeuronMocap.Tool.View.Characters;
using NeuronMocap.Tool.View.Control;
using NeuronMocap.Tool.View.Figures;
using NeuronMocap.Tool.View.Live;
using NeuronMocap.Tool.View.Performers;
using NeuronMocap.Tool.View.Takes;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View;

/// <summary>One run of the viewer, from the options to its end. It ends with its duration or a request of the user.</summary>
internal sealed class ViewRun(ViewOptions options, StandardStreams streams)
{
    // A new upload is saved before the oldest take is closed.
    private const long UploadsThatFit = TakeLibrary.MostTakes + 1;

    private static readonly string Version = Assembly.GetExecutingAssembly().GetCustomAttribute<AssemblyInformationalVersionAttribute>()!.InformationalVersion;

    public async Task<int> RunAsync(CancellationToken cancellationToken)
    {
        try
        {
            return options.Source.File is { } file ? await ShowFileAsync(file, cancellationToken) : await ShowStreamAsync(cancellationToken);
        }
        catch (BroadcasterException exception)
        {
            return await FailAsync(DescribePort(exception));
        }
        catch (ApiException exception)
        {
            return await FailAsync(exception.Message);
        }
        catch (OperationCanceledException) when (cancellationToken.IsCancellationRequested)
        {
            return ToolCommand.Done;
        }
    }

    private async Task<int> ShowFileAsync(string file, CancellationToken cancellationToken)
    {
        using ScratchFolder scratch = CreateScratch();
        string? take = null;
        await using var hub = new ControlHub(() => [Hello("take", take, canCommand: false, performers: [])]);
        await using TakeService takes = CreateTakes(scratch, hub);
        await using var characters = new CharacterLibrary(live: null, takes);
        take = await takes.OpenAsync(file, options.Connection.RotationOrder, cancellationToken);
        await ServeAsync([hub, takes, characters], cancellationToken);
        return ToolCommand.Done;
    }

    private async Task<int> ShowStreamAsync(CancellationToken cancellationToken)
    {
        await using DemoSource? demo = options.Connection.IsDemo ? DemoSource.Start(options.Connection.RotationOrder) : null;
        NeuronReaderOptions readerOptions = options.Connection.ToReaderOptions(demo?.Stream ?? options.Connection.Server);
        using ScratchFolder scratch = CreateScratch();
        await using var reader = new NeuronReader(readerOptions);
        ServerAddress? commands = demo?.Commands ?? CommandsOf(options.Connection);
        LiveSession? live = null;
        RecordingControl? recording = null;
        await using var hub = new ControlHub(() => [Hello("live", take: null, commands is not null, live!.Introduce()), .. live.Greet(), .. recording!.Greet()]);
        await using TakeService takes = CreateTakes(scratch, hub);
        await using (live = new LiveSession(reader, options.Source.ToString(), hub))
        await using (var characters = new CharacterLibrary(live, takes))
        await using (recording = new RecordingControl(reader, options.RecordFolder ?? string.Empty, hub, takes))
        {
            live.Ticked += recording.Report;
            IViewPart[] parts =
            [
                hub, live, recording,
                new DiagnosisAction(options.Source, readerOptions, () => LiveDiagnosis.Of(live.Describe())),
                new ZeroOutAction(commands, options.Connection.LocalAddress),
                new FigureFiles(live.Performers.Find),
                takes,
                characters,
            ];
            reader.Start();
            await ServeAsync(parts, cancellationToken);
            await reader.DisposeAsync();
            return await recording.FinishAsync(streams) ? ToolCommand.Done : ToolCommand.NothingReceived;
        }
    }

    private static ServerAddress? CommandsOf(ConnectionOptions connection) =>
        connection is { Server: { } server, CommandPort: { } port } ? server with { Port = port } : null;

    private HelloJson Hello(string mode, string? take, bool canCommand, IReadOnlyList<PerformerJson> performers) =>
        new(ToolCommand.Name, Version, mode, options.Source.ToString(), take, canCommand, options.UploadMegabytes * BodyLimit.Megabyte, performers);

    private ScratchFolder CreateScratch()
    {
        try
        {
            return new ScratchFolder(UploadsThatFit * options.UploadMegabytes * BodyLimit.Megabyte);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            throw ApiException.Conflict(TemporaryFolderFault.Describe());
        }
    }

    private TakeService CreateTakes(ScratchFolder scratch, ControlHub hub) => new TakeService(scratch, hub, options.UploadMegabytes, TakeLibrary.NewRun());

    private async Task ServeAsync(IReadOnlyList<IViewPart> parts, CancellationToken cancellationToken)
    {
        await using ViewServer server = await ViewServer.StartAsync(options, parts);
        new Announcement(options, streams).Write(server);
        using var durationSource = new CancellationTokenSource(options.Connection.Duration ?? Timeout.InfiniteTimeSpan);
        using var stopSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken, durationSource.Token);
        await Task.Delay(Timeout.Infinite, stopSource.Token).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
    }

    private string DescribePort(BroadcasterException exception) => StartFailure.DescribeArgument(
        exception, exception.Setting is nameof(BroadcasterOptions.Port) ? "--port" : "--bind", new IPEndPoint(options.Bind, options.Port ?? ViewOptions.DefaultPort));

    private async Task<int> FailAsync(string message)
    {
        await streams.ComplainAsync(message);
        return ToolCommand.NothingReceived;
    }
}
