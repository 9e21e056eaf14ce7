using System.Net;
using System.Reflection;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Simulate;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.View.Characters;
using NeuronMocap.Tool.View.Control;
using NeuronMocap.Tool.View.Live;
using NeuronMocap.Tool.View.Performers;
using NeuronMocap.Tool.View.Takes;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View;

/// <summary>One run of the viewer, from the options to its end. It ends with its duration or a request of the user.</summary>
internal sealed class ViewRun(ViewOptions options, StandardStreams streams)
{
    private const int WidestText = 160;
    private const long UploadsThatFit = 8;

    private static readonly string Version = Assembly.GetExecutingAssembly().GetCustomAttribute<AssemblyInformationalVersionAttribute>()!.InformationalVersion;

    private readonly TextPage _page = new(streams, WidestText);

    // Called with the server once it listens.
    internal Action<ViewServer>? Listening { get; init; }

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
        using var scratch = CreateScratch();
        string? take = null;
        await using var hub = new ControlHub(() => [Hello("take", take, performers: [])]);
        await using ITakeLibrary takes = CreateTakes(scratch, hub);
        await using var characters = new CharacterLibrary(live: null, takes);
        take = await takes.OpenAsync(file, cancellationToken);
        return await ServeAsync([hub, takes, characters], cancellationToken);
    }

    private async Task<int> ShowStreamAsync(CancellationToken cancellationToken)
    {
        using Broadcaster? demo = options.Connection.IsDemo ? Broadcaster.StartDemo(rotationOrder: options.Connection.RotationOrder ?? RotationOrder.YXZ) : null;
        ServerAddress? server = demo is null ? options.Connection.Server : ServerAddress.Of(demo.LocalEndPoint!);
        using var scratch = CreateScratch();
        await using var reader = new NeuronReader(options.Connection.ToReaderOptions(server));
        LiveSession? live = null;
        await using var hub = new ControlHub(() => [Hello("live", take: null, live!.Introduce()), .. live.Greet()]);
        await using (live = new LiveSession(reader, options.Source.ToString(), hub))
        await using (ITakeLibrary takes = CreateTakes(scratch, hub))
        {
            await using var characters = new CharacterLibrary(live, takes);
            reader.Start();
            return await ServeAsync([hub, live, takes, characters], cancellationToken);
        }
    }

    private HelloJson Hello(string mode, string? take, IReadOnlyList<PerformerJson> performers) =>
        new(ToolCommand.Name, Version, mode, options.Source.ToString(), take, CanCommand: options.Connection.CommandPort is not null, performers);

    private ScratchFolder CreateScratch() => new(UploadsThatFit * options.UploadMegabytes * BodyLimit.Megabyte);

    private ITakeLibrary CreateTakes(ScratchFolder scratch, ControlHub hub) => new TakeService(scratch, hub, options.UploadMegabytes);

    private async Task<int> ServeAsync(IReadOnlyList<IViewPart> parts, CancellationToken cancellationToken)
    {
        await using ViewServer server = await ViewServer.StartAsync(options, parts);
        Announce(server);
        Listening?.Invoke(server);
        using var durationSource = new CancellationTokenSource(options.Connection.Duration ?? Timeout.InfiniteTimeSpan);
        using var stopSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken, durationSource.Token);
        await Task.Delay(Timeout.Infinite, stopSource.Token).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        return ToolCommand.Done;
    }

    private void Announce(ViewServer server)
    {
        if (!PageFiles.Exist)
            streams.Complain($"This build does not contain the page. Install Node.js, then run: {PageFiles.BuildCommand}");

        _page.WriteLine($"Viewing {options.Source} at http://{server.LocalEndPoint}/");
    }

    private string DescribePort(BroadcasterException exception) =>
        StartFailure.DescribeArgument(exception, exception.Setting is nameof(BroadcasterOptions.Port) ? "--port" : "--bind", new IPEndPoint(options.Bind, options.Port ?? ViewOptions.DefaultPort));

    private async Task<int> FailAsync(string message)
    {
        await streams.ComplainAsync(message);
        return ToolCommand.NothingReceived;
    }
}
