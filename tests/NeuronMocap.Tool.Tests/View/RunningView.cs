using System.Net.Http.Headers;
using System.Text;
using System.Text.Json;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Tests.View;

/// <summary>A run of the verb inside the test process, on a free port of this computer.</summary>
internal sealed class RunningView : IAsyncDisposable
{
    private readonly CancellationTokenSource _stop = CancellationTokenSource.CreateLinkedTokenSource(TestContext.Current.CancellationToken);
    private readonly LineStream _output = new();
    private readonly StringWriter _error = new();
    private readonly StandardStreams _streams;
    private readonly Task<int> _run;

    private RunningView(string[] args)
    {
        _streams = new StandardStreams(_output, TextWriter.Synchronized(_error), IsTerminal: false);
        _run = Task.Run(() => CommandLine.RunAsync(["view", .. args], _streams, _stop.Token));
    }

    /// <summary>The link for this computer, with a token if there is one.</summary>
    public Uri Link { get; private set; } = null!;

    /// <summary>Sends the token by itself, if there is one.</summary>
    public HttpClient Client { get; } = new(new SocketsHttpHandler { Expect100ContinueTimeout = Limits.Unexpected });

    public string Error => _error.ToString();

    public static Task<RunningView> StartAsync(params string[] args) => StartAsItIsAsync([.. args, .. args.Contains("--port") ? (string[])[] : ["--port", "0"]]);

    /// <summary>Starts on the port that the program chooses unless the arguments name one.</summary>
    public static async Task<RunningView> StartAsItIsAsync(params string[] args)
    {
        var view = new RunningView(args);
        const string Start = " on http://";
        string line = await view.FindLineAsync("Viewing ");
        view.Link = new Uri(line[(line.IndexOf(Start, StringComparison.Ordinal) + " on ".Length)..]);
        view.Client.BaseAddress = new Uri(view.Link, "/");
        if (view.Link.Query.Length > 0)
            view.Client.DefaultRequestHeaders.Authorization = new AuthenticationHeaderValue("Bearer", view.Link.Query["?token=".Length..]);

        return view;
    }

    /// <summary>Waits for a line of the output: the run writes on while a test uses it.</summary>
    public Task<string> FindLineAsync(string start) => _output.FindAsync(line => line.StartsWith(start, StringComparison.Ordinal), _run);

    public async Task<JsonElement> GetAsync(string path)
    {
        using HttpResponseMessage answer = await Client.GetAsync(path, TestContext.Current.CancellationToken).Soon();
        return await ReadAsync(answer);
    }

    public async Task<(int Status, JsonElement Answer)> PostAsync(string path, string body = "")
    {
        // The server closes the connection when it refuses a body. Its answer could be lost while the client still sends, so the client asks first.
        using var request = new HttpRequestMessage(HttpMethod.Post, path) { Content = new StringContent(body, Encoding.UTF8, "application/json") };
        request.Headers.ExpectContinue = body.Length > 0;
        using HttpResponseMessage answer = await Client.SendAsync(request, TestContext.Current.CancellationToken).Soon();
        return ((int)answer.StatusCode, await ReadAsync(answer));
    }

    public Task<ViewSocket> ConnectAsync(string path, string? subprotocol = null, Action<System.Net.WebSockets.ClientWebSocketOptions>? configure = null) =>
        ViewSocket.ConnectAsync(new UriBuilder(Link) { Scheme = "ws", Path = path }.Uri, subprotocol, configure);

    /// <summary>Ends the run as Ctrl+C does.</summary>
    public async Task<int> StopAsync()
    {
        await _stop.CancelAsync();
        return await _run.Soon();
    }

    public async ValueTask DisposeAsync()
    {
        await StopAsync();
        Client.Dispose();
        _streams.Dispose();
        _stop.Dispose();
        await _error.DisposeAsync();
    }

    private static async Task<JsonElement> ReadAsync(HttpResponseMessage answer) =>
        JsonDocument.Parse(await answer.Content.ReadAsByteArrayAsync(TestContext.Current.CancellationToken)).RootElement;

    // Lets a test wait for a line.
    private sealed class LineStream : MemoryStream
    {
        private readonly Lock _lock = new();
        private TaskCompletionSource _written = new(TaskCreationOptions.RunContinuationsAsynchronously);

        public string Text
        {
            get
            {
                lock (_lock)
                    return Encoding.UTF8.GetString(ToArray());
            }
        }

        public async Task<string> FindAsync(Predicate<string> isWanted, Task run)
        {
            while (true)
            {
                Task written = Volatile.Read(ref _written).Task;
                if (Array.Find(Text.Split('\n')[..^1], isWanted) is { } line)
                    return line;

                Assert.False(run.IsCompleted, "The run ended before it listened.");
                await Task.WhenAny(written, run).Soon();
            }
        }

        // The base class passes spans of derived classes on as arrays.
        public override void Write(byte[] buffer, int offset, int count)
        {
            lock (_lock)
                base.Write(buffer, offset, count);

            Interlocked.Exchange(ref _written, new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously)).TrySetResult();
        }
    }
}
