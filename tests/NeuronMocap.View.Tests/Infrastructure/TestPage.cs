using System.Collections.Concurrent;
using System.Text.Json;

namespace NeuronMocap.View.Tests.Infrastructure;

/// <summary>A page in a context of its own. It remembers what must not happen: faults in the console, and requests to other servers.</summary>
internal sealed class TestPage : IAsyncDisposable
{
    /// <summary>Milliseconds to wait for something that happens at once on an idle computer.</summary>
    public const int Patience = 120_000;

    private const string Hook = "window.neuronMocap";

    private readonly IBrowserContext _context;
    private readonly ConcurrentQueue<string> _faults = [];
    private readonly ConcurrentQueue<string> _foreign = [];
    private readonly ConcurrentDictionary<IWebSocket, bool> _sockets = [];

    private TestPage(IBrowserContext context, IPage page) => (_context, Page) = (context, page);

    public IPage Page { get; }

    /// <summary>The sockets that are open now.</summary>
    public IEnumerable<string> OpenSockets => _sockets.Keys.Where(static socket => !socket.IsClosed).Select(static socket => new Uri(socket.Url).AbsolutePath);

    /// <summary>Opens a page of a running viewer.</summary>
    /// <param name="browser">The browser.</param>
    /// <param name="link">The page.</param>
    /// <param name="width">Pixels.</param>
    /// <param name="height">Pixels. A small picture is quick to draw.</param>
    /// <param name="theme">The theme of the system.</param>
    public static async Task<TestPage> OpenAsync(SharedBrowser browser, Uri link, int width = 480, int height = 400, ColorScheme theme = ColorScheme.Dark)
    {
        IBrowserContext context = await (await browser.StartAsync()).NewContextAsync(new BrowserNewContextOptions
        {
            ViewportSize = new ViewportSize { Width = width, Height = height },
            ColorScheme = theme,
            ReducedMotion = ReducedMotion.Reduce,
        });
        context.SetDefaultTimeout(Patience);
        var test = new TestPage(context, await context.NewPageAsync());
        try
        {
            await test.WatchAsync(link);
            await test.Page.GotoAsync(link.ToString());
            await test.UntilAsync("() => window.neuronMocap !== undefined");
            return test;
        }
        catch
        {
            await context.CloseAsync();
            throw;
        }
    }

    /// <summary>Waits until an expression of the page is true.</summary>
    public Task UntilAsync(string condition, object? argument = null) => Page.WaitForFunctionAsync(condition, argument);

    /// <summary>Waits until performers are shown with their figures.</summary>
    public Task UntilMovingAsync(int performers = 1) => UntilAsync(
        $"count => {{ const all = {Hook}.state().performers; return all.length === count && all.every(each => each.poses > 0 && each.hasFigure); }}", performers);

    /// <summary>Calls a function of the page.</summary>
    /// <returns>The result as JSON, or Undefined for a function without result.</returns>
    public async Task<JsonElement> EvaluateAsync(string function, object? argument = null)
    {
        // As text, because the driver adds numbers of its own to nested objects.
        string? text = await Page.EvaluateAsync<string?>($"async argument => JSON.stringify(await ({function})(argument))", argument);
        return text is null ? default : JsonDocument.Parse(text).RootElement;
    }

    public Task<JsonElement> StateAsync() => EvaluateAsync($"() => {Hook}.state()");

    /// <summary>Chooses files in the dialog that an action opens.</summary>
    public async Task ChooseAsync(Func<Task> action, params string[] files)
    {
        IFileChooser chooser = await Page.RunAndWaitForFileChooserAsync(action);
        await chooser.SetFilesAsync(files);
    }

    /// <summary>Drops a file on the page.</summary>
    public Task DropAsync(string name, byte[] contents) => DropAsync((name, contents));

    /// <summary>Drops several files together.</summary>
    public async Task DropAsync(params (string Name, byte[] Contents)[] files)
    {
        const string Script = """
            files => {
              const transfer = new DataTransfer();
              for (const { name, text } of files)
                transfer.items.add(new File([Uint8Array.from(atob(text), letter => letter.charCodeAt(0))], name));
              document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
            }
            """;
        await Page.EvaluateAsync(Script, files.Select(static file => new { name = file.Name, text = Convert.ToBase64String(file.Contents) }).ToArray());
    }

    /// <summary>Checks that the page caused no fault.</summary>
    /// <param name="isExpected">The faults that the test itself provokes.</param>
    public void AssertClean(Predicate<string>? isExpected = null)
    {
        Assert.Empty(_foreign);
        Assert.DoesNotContain(_faults, fault => isExpected?.Invoke(fault) != true);
    }

    public async ValueTask DisposeAsync() => await _context.CloseAsync();

    private async Task WatchAsync(Uri link)
    {
        Page.Console += (_, message) =>
        {
            if (message.Type is "error" or "warning" && !IsOfRenderer(message.Text))
                _faults.Enqueue($"{message.Type}: {message.Text}");
        };
        Page.PageError += (_, error) => _faults.Enqueue(error);
        Page.WebSocket += (_, socket) =>
        {
            _sockets[socket] = true;
            CheckServer(new Uri(socket.Url), link);
        };
        // From now on the driver catches the dialogs for files. If it began when a test waits for one, the dialog could come first.
        Page.FileChooser += static (_, _) => { };
        await _context.RouteAsync("**/*", route =>
        {
            var address = new Uri(route.Request.Url);
            return CheckServer(address, link) ? route.ContinueAsync() : route.AbortAsync();
        });
    }

    private bool CheckServer(Uri address, Uri link)
    {
        bool isOwn = address.Scheme is "data" or "blob" || address.Authority == link.Authority;
        if (!isOwn)
            _foreign.Enqueue(address.ToString());
        return isOwn;
    }

    // What Chromium says about drawing without a graphics card.
    private static bool IsOfRenderer(string text) =>
        text.Contains("GPU stall due to ReadPixels", StringComparison.Ordinal) || text.Contains("software WebGL", StringComparison.Ordinal);
}
