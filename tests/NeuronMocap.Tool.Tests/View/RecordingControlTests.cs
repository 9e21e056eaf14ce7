using System.Text;
using System.Text.Json;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Routing;
using Microsoft.Extensions.DependencyInjection;
using NeuronMocap.Recording;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.View;
using NeuronMocap.Tool.View.Actions;
using NeuronMocap.Tool.View.Control;
using NeuronMocap.Tool.View.Takes;

namespace NeuronMocap.Tool.Tests.View;

public sealed class RecordingControlTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task A_page_that_leaves_while_the_recording_ends_cancels_nothing()
    {
        await using Broadcaster broadcaster = Broadcaster.StartDemo();
        await using var reader = new NeuronReader(new NeuronReaderOptions { Host = "127.0.0.1", Port = broadcaster.LocalEndPoint!.Port });
        await using var hub = new ControlHub(static () => []);
        var library = new Library();
        await using var control = new RecordingControl(reader, _folder[string.Empty], hub, library);
        reader.Start();
        RequestDelegate handle = HandlerOf(control);
        await handle(RequestFor("start", CancellationToken.None));
        using var leaves = new CancellationTokenSource();
        DefaultHttpContext request = RequestFor("stop", leaves.Token);
        request.Request.Body = new LastRead(request.Request.Body, leaves);

        try
        {
            await handle(request);
        }
        catch (OperationCanceledException)
        {
            // There is nobody to answer.
        }

        Assert.Equal(_folder[Assert.Single(_folder.Names)], library.Opened);
        Assert.Equal(RecordingMessage.Idle, control.Describe().State);
    }

    [Fact]
    public async Task A_recording_that_starts_while_another_one_ends_is_shown()
    {
        await using Broadcaster broadcaster = Broadcaster.StartDemo();
        await using var reader = new NeuronReader(new NeuronReaderOptions { Host = "127.0.0.1", Port = broadcaster.LocalEndPoint!.Port });
        await using var hub = new ControlHub(static () => []);
        var library = new Library();
        await using var control = new RecordingControl(reader, _folder[string.Empty], hub, library);
        var options = new ViewOptions(Source.Demo, new ConnectionOptions()) { Port = 0 };
        await using ViewServer server = await ViewServer.StartAsync(options, [hub]);
        using ViewSocket page = await ViewSocket.ConnectAsync(new Uri($"ws://{server.LocalEndPoint}/control"), subprotocol: null, configure: null);
        await Limits.UntilAsync(() => hub.Clients == 1);
        reader.Start();
        RequestDelegate handle = HandlerOf(control);
        await handle(RequestFor("start", CancellationToken.None));
        library.Opening = () => handle(RequestFor("start", CancellationToken.None));

        await handle(RequestFor("stop", CancellationToken.None));

        hub.Send(new ProblemMessage("The last message."));
        Assert.Equal(RecordingMessage.Recording, await FindStateAsync(page));
        Assert.Equal(2, _folder.Names.Length);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task A_finished_recording_tells_whether_it_holds_motion(bool hasMotion)
    {
        await using Broadcaster broadcaster = Broadcaster.StartDemo();
        await using var reader = new NeuronReader(new NeuronReaderOptions { Host = "127.0.0.1", Port = broadcaster.LocalEndPoint!.Port });
        await using var hub = new ControlHub(static () => []);
        await using var control = new RecordingControl(reader, _folder[string.Empty], hub, new Library());
        RequestDelegate handle = HandlerOf(control);
        await handle(RequestFor("start", CancellationToken.None));
        if (hasMotion)
        {
            reader.Start();
            await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames > 0);
        }

        await handle(RequestFor("stop", CancellationToken.None));

        RecordingMessage finished = Assert.IsType<RecordingMessage>(control.Greet()[0]);
        Assert.Equal(hasMotion, finished.Frames > 0);
        Assert.Equal(0, RecordingMessage.None.Frames);
    }

    [Fact]
    public async Task A_recording_that_fails_while_another_one_runs_does_not_hide_it()
    {
        using FullDevice full = await FullDevice.LinkAsync(_folder["older.0002.nmrec"]);
        await using Broadcaster broadcaster = Broadcaster.StartDemo();
        await using var reader = new NeuronReader(new NeuronReaderOptions { Host = "127.0.0.1", Port = broadcaster.LocalEndPoint!.Port });
        await using var hub = new ControlHub(static () => []);
        await using var control = new RecordingControl(reader, _folder[string.Empty], hub, new Library());
        await using ViewServer server = await ViewServer.StartAsync(new ViewOptions(Source.Demo, new ConnectionOptions()) { Port = 0 }, [hub]);
        using ViewSocket page = await ViewSocket.ConnectAsync(new Uri($"ws://{server.LocalEndPoint}/control"), subprotocol: null, configure: null);
        await Limits.UntilAsync(() => hub.Clients == 1);
        StreamRecorder older = reader.StartRecording(_folder["older.nmrec"], new RecordingOptions { MaxFileDuration = TimeSpan.FromSeconds(1), Overwrite = true });
        reader.Start();
        await HandlerOf(control)(RequestFor("start", CancellationToken.None));

        await Limits.UntilAsync(() => older.Failure is not null);

        Assert.Equal(RecordingMessage.Recording, await FindStateAsync(page));
        JsonElement after = JsonDocument.Parse((await page.ReceiveAsync())!).RootElement;
        Assert.Equal("recording", after.GetProperty("type").GetString());
        Assert.Equal(RecordingMessage.Recording, after.GetProperty("state").GetString());
        Assert.StartsWith("neuron-", after.GetProperty("file").GetString(), StringComparison.Ordinal);
    }

    // The state that a page shows when it receives a problem.
    private static async Task<string?> FindStateAsync(ViewSocket page)
    {
        string? state = null;
        while (await page.ReceiveAsync() is { } bytes)
        {
            JsonElement message = JsonDocument.Parse(bytes).RootElement;
            if (message.GetProperty("type").ValueEquals("problem"))
                break;
            if (message.GetProperty("type").ValueEquals("recording"))
                state = message.GetProperty("state").GetString();
        }

        return state;
    }

    private static RequestDelegate HandlerOf(RecordingControl control)
    {
        WebApplicationBuilder builder = WebApplication.CreateEmptyBuilder(new WebApplicationOptions());
        builder.WebHost.UseKestrelCore();
        builder.Services.AddRoutingCore();
        IEndpointRouteBuilder endpoints = builder.Build();
        control.Map(endpoints);
        return endpoints.DataSources.SelectMany(static source => source.Endpoints).Single().RequestDelegate!;
    }

    private static DefaultHttpContext RequestFor(string action, CancellationToken aborted) => new()
    {
        RequestAborted = aborted,
        Request = { Body = new MemoryStream(Encoding.UTF8.GetBytes($$"""{"action":"{{action}}"}""")) },
    };

    private sealed class Library : ITakeLibrary
    {
        public string? Opened { get; private set; }

        /// <summary>Runs while a take is opened.</summary>
        public Func<Task>? Opening { get; set; }

        public async Task<string> OpenAsync(string path, RotationOrder? order, CancellationToken cancellationToken)
        {
            cancellationToken.ThrowIfCancellationRequested();
            Opened = path;
            if (Opening is { } opening)
                await opening();

            return "t1";
        }

        public Task<TakePerformer?> FindPerformerAsync(string key, CancellationToken cancellationToken) => Task.FromResult<TakePerformer?>(null);

        public void Map(IEndpointRouteBuilder endpoints)
        {
        }

        public ValueTask DisposeAsync() => ValueTask.CompletedTask;
    }

    // Cancels at its end.
    private sealed class LastRead(Stream body, CancellationTokenSource end) : MemoryStream
    {
        public override async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellationToken = default)
        {
            int count = await body.ReadAsync(buffer, CancellationToken.None);
            if (count == 0)
                await end.CancelAsync();

            return count;
        }
    }
}
