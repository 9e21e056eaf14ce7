using System.Collections.Concurrent;
using System.Text.Json;

namespace NeuronMocap.View.Tests.Infrastructure;

/// <summary>
/// A page that knows nothing of other tests. It remembers what must not happen: faults in the console, and requests to other servers.
/// </summary>
internal sealed class TestPage : IAsyncDisposable
{
    /// <summary>Milliseconds to wait for something that happens at once on an idle computer.</summary>
    public const int Patience = 120_000;

    private const string Hook = "window.neuronMocap";

    // Most processor time goes into pictures that nobody sees. A page makes 15 a second, and draws them only for a test that asks for it.
    private const string FewPictures = """
        (() => {
          const request = window.requestAnimationFrame.bind(window);
          window.requestAnimationFrame = callback => setTimeout(() => request(callback), 50);
          for (const name of ["drawArrays", "drawElements", "drawArraysInstanced", "drawElementsInstanced"]) {
            const draw = WebGL2RenderingContext.prototype[name];
            WebGL2RenderingContext.prototype[name] = function (...values) {
              if (window.testDraws)
                draw.apply(this, values);
            };
          }
        })();
        """;

    // With the policy of the program, so that the browser sees no reason for a new process.
    private static readonly Dictionary<string, string> EmptyPage = new() { ["Content-Type"] = "text/html", ["Cross-Origin-Opener-Policy"] = "same-origin" };

    private readonly SharedBrowser _browser;
    private readonly Uri _link;
    private readonly bool _isKept;
    private readonly ConcurrentQueue<string> _faults = [];
    private readonly ConcurrentQueue<string> _foreign = [];
    private readonly ConcurrentDictionary<IWebSocket, bool> _sockets = [];

    private TestPage(SharedBrowser browser, IPage page, Uri link, bool isKept) => (_browser, Page, _link, _isKept) = (browser, page, link, isKept);

    public IPage Page { get; }

    /// <summary>The sockets that are open now.</summary>
    public IEnumerable<string> OpenSockets => _sockets.Keys.Where(static socket => !socket.IsClosed).Select(static socket => new Uri(socket.Url).AbsolutePath);

    /// <summary>Opens a page of a running viewer.</summary>
    /// <param name="browser">The browser.</param>
    /// <param name="link">The page.</param>
    /// <param name="width">Pixels.</param>
    /// <param name="height">Pixels. A small picture is quick to draw.</param>
    /// <param name="theme">The theme of the system.</param>
    /// <param name="draws">Draws, and so finds what WebGL refuses. Otherwise nothing is drawn, but joints, texts and buttons work.</param>
    /// <param name="asInstalled">Draws all pictures, in a new page, as for a person.</param>
    /// <param name="script">Runs before the scripts of the page, which is a new one.</param>
    public static async Task<TestPage> OpenAsync(
        SharedBrowser browser, Uri link, int width = 480, int height = 400, ColorScheme theme = ColorScheme.Dark, bool draws = false, bool asInstalled = false, string? script = null)
    {
        bool isKept = !asInstalled && script is null;
        IPage page = (isKept ? browser.TakeIdle() : null) ?? await CreateAsync(browser, asInstalled, script);
        var test = new TestPage(browser, page, link, isKept);
        try
        {
            await page.SetViewportSizeAsync(width, height);
            await page.EmulateMediaAsync(new PageEmulateMediaOptions { ColorScheme = theme, ReducedMotion = ReducedMotion.Reduce });
            test.Watch();
            await page.GotoAsync(link.ToString());
            await test.UntilAsync("draws => { window.testDraws = draws; return window.neuronMocap !== undefined; }", draws);
            return test;
        }
        catch
        {
            await page.Context.CloseAsync();
            throw;
        }
    }

    /// <summary>Waits until an expression of the page is true.</summary>
    public async Task UntilAsync(string condition, object? argument = null)
    {
        try
        {
            await Page.WaitForFunctionAsync(condition, argument);
        }
        catch (TimeoutException)
        {
            string? shown = await Page.EvaluateAsync<string?>($"() => JSON.stringify({Hook}?.state()) + ' ' + document.body.innerText");
            Assert.Fail($"Not in time: {condition}\nFaults: {string.Join("; ", _faults)}\nThe page: {shown}");
        }
    }

    /// <summary>Waits until performers are shown with their figures.</summary>
    public Task UntilMovingAsync(int performers = 1) => UntilAsync(
        $"count => {{ const all = {Hook}.state().performers; return all.length === count && all.every(each => each.poses > 0 && each.hasFigure); }}", performers);

    /// <summary>Waits for pictures from now on.</summary>
    public async Task UntilDrawnAsync(int pictures = 1)
    {
        int before = (await EvaluateAsync($"() => {Hook}.stats().pictures")).GetInt32();
        await UntilAsync($"most => {Hook}.stats().pictures >= most", before + pictures);
    }

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

    /// <summary>Leaves the page for the next test. A page that does not answer is closed.</summary>
    public async ValueTask DisposeAsync()
    {
        if (!_isKept || Page.IsClosed || !await ForgetAsync() || !_browser.Keep(Page))
            await Page.Context.CloseAsync();
    }

    private static async Task<IPage> CreateAsync(SharedBrowser browser, bool asInstalled, string? script)
    {
        IBrowserContext context = await (await browser.StartAsync(asInstalled)).NewContextAsync();
        context.SetDefaultTimeout(Patience);
        if (!asInstalled)
            await context.AddInitScriptAsync(FewPictures);
        if (script is not null)
            await context.AddInitScriptAsync(script);
        IPage page = await context.NewPageAsync();
        // From now on the driver catches the dialogs for files. If it began when a test waits for one, the dialog could come first.
        page.FileChooser += static (_, _) => { };
        return page;
    }

    // Settings and cookies must not meet another test. An empty page of the same server ends the page, and keeps its process. The server itself may have ended.
    private async Task<bool> ForgetAsync()
    {
        Page.Console -= OnConsole;
        Page.PageError -= OnPageError;
        Page.WebSocket -= OnWebSocket;
        Page.Request -= OnRequest;
        try
        {
            await Page.UnrouteAllAsync();
            await Page.RouteAsync("**/*", static route => route.FulfillAsync(new RouteFulfillOptions { Headers = EmptyPage, Body = string.Empty }));
            await Page.GotoAsync(new Uri(_link, "/empty").ToString());
            await Page.EvaluateAsync("() => { localStorage.clear(); sessionStorage.clear(); }");
            await Page.Context.ClearCookiesAsync();
            await Page.UnrouteAllAsync();
            return true;
        }
        catch (PlaywrightException)
        {
            return false;
        }
    }

    private void Watch()
    {
        Page.Console += OnConsole;
        Page.PageError += OnPageError;
        Page.WebSocket += OnWebSocket;
        Page.Request += OnRequest;
    }

    private void OnConsole(object? sender, IConsoleMessage message)
    {
        if (message.Type is "error" or "warning" && !IsOfRenderer(message.Text))
            _faults.Enqueue($"{message.Type}: {message.Text}");
    }

    private void OnPageError(object? sender, string error) => _faults.Enqueue(error);

    private void OnWebSocket(object? sender, IWebSocket socket)
    {
        _sockets[socket] = true;
        CheckServer(socket.Url);
    }

    private void OnRequest(object? sender, IRequest request) => CheckServer(request.Url);

    private void CheckServer(string url)
    {
        var address = new Uri(url);
        if (address.Scheme is not ("data" or "blob") && address.Authority != _link.Authority)
            _foreign.Enqueue(url);
    }

    // What Chromium says about drawing without a graphics card.
    private static bool IsOfRenderer(string text) =>
        text.Contains("GPU stall due to ReadPixels", StringComparison.Ordinal) || text.Contains("software WebGL", StringComparison.Ordinal);
}
