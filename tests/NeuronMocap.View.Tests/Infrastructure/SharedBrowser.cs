using NeuronMocap.View.Tests.Infrastructure;

[assembly: AssemblyFixture(typeof(SharedBrowser))]
// A software renderer draws the pages. Side by side they would only wait for each other.
[assembly: CollectionBehavior(DisableTestParallelization = true)]

namespace NeuronMocap.View.Tests.Infrastructure;

/// <summary>The Chromium of the system, started once for all tests.</summary>
public sealed class SharedBrowser : IAsyncDisposable
{
    // New processes and their first scripts are most of what a page costs. After so many tests, a page is replaced with all that it has gathered.
    private const int TestsPerPage = 20;

    private static readonly string[] Names = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

    // The same without windows and what belongs to them. It takes a sixth less processor time.
    private const string WithoutWindows = "chromium-headless-shell";

    // The last list of features that the driver disables counts alone, and a part of it is needed. So features have no place here.
    private static readonly string[] Basic = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

    // Without a graphics card, the processor draws the texts and puts the page together by itself at less cost. No test asks a server of others.
    private static readonly string[] Cheap = ["--disable-gpu-rasterization", "--disable-gpu-compositing", "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"];

    private IPlaywright? _playwright;
    private IBrowser? _browser;
    private IPage? _idle;
    private int _tests;

    /// <summary>Starts the browser at the first call. Skips the test if there is no browser or no page.</summary>
    /// <param name="asInstalled">Draws as for a person. The first call decides.</param>
    public async Task<IBrowser> StartAsync(bool asInstalled = false)
    {
        string? path = (asInstalled ? Names : [WithoutWindows, .. Names]).Select(InstalledPrograms.PathOf).FirstOrDefault(static found => found is not null);
        Assert.SkipWhen(path is null, "There is no Chromium and no Chrome on the PATH.");
        Assert.SkipWhen(typeof(NeuronMocap.Tool.View.ViewOptions).Assembly.GetManifestResourceInfo("web/app.js.gz") is null, "The program is built without its page.");
        if (_browser is not null)
            return _browser;

        Environment.SetEnvironmentVariable("PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD", "1");
        _playwright = await Playwright.CreateAsync();
        return _browser = await _playwright.Chromium.LaunchAsync(new BrowserTypeLaunchOptions
        {
            ExecutablePath = path,
            Args = asInstalled ? Basic : [.. Basic, .. Cheap],
            Timeout = TestPage.Patience,
        });
    }

    /// <summary>Takes the page that waits for a test, or null.</summary>
    internal IPage? TakeIdle() => Interlocked.Exchange(ref _idle, null);

    /// <summary>Keeps a page for another test.</summary>
    /// <param name="page">A page that knows nothing of the last test.</param>
    /// <returns>False if the page is not wanted.</returns>
    internal bool Keep(IPage page)
    {
        if (++_tests % TestsPerPage == 0)
            return false;

        return Interlocked.CompareExchange(ref _idle, page, null) is null;
    }

    public async ValueTask DisposeAsync()
    {
        if (_browser is not null)
            await _browser.DisposeAsync();
        _playwright?.Dispose();
    }
}
