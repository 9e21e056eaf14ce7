using NeuronMocap.View.Tests.Infrastructure;

[assembly: AssemblyFixture(typeof(SharedBrowser))]
// A software renderer draws the pages. Side by side they would only wait for each other.
[assembly: CollectionBehavior(DisableTestParallelization = true)]

namespace NeuronMocap.View.Tests.Infrastructure;

/// <summary>The Chromium of the system, started once for all tests.</summary>
public sealed class SharedBrowser : IAsyncDisposable
{
    private static readonly string[] Names = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

    private IPlaywright? _playwright;
    private IBrowser? _browser;

    /// <summary>Starts the browser at the first call. Skips the test if there is no browser or no page.</summary>
    public async Task<IBrowser> StartAsync()
    {
        string? path = FindBrowser();
        Assert.SkipWhen(path is null, "There is no Chromium and no Chrome on the PATH.");
        Assert.SkipWhen(typeof(NeuronMocap.Tool.View.ViewOptions).Assembly.GetManifestResourceInfo("web/app.js.gz") is null, "The program is built without its page.");
        if (_browser is not null)
            return _browser;

        Environment.SetEnvironmentVariable("PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD", "1");
        _playwright = await Playwright.CreateAsync();
        return _browser = await _playwright.Chromium.LaunchAsync(new BrowserTypeLaunchOptions
        {
            ExecutablePath = path,
            Args = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
            Timeout = TestPage.Patience,
        });
    }

    public async ValueTask DisposeAsync()
    {
        if (_browser is not null)
            await _browser.DisposeAsync();
        _playwright?.Dispose();
    }

    private static string? FindBrowser() => (Environment.GetEnvironmentVariable("PATH") ?? string.Empty)
        .Split(Path.PathSeparator)
        .SelectMany(static folder => Names.Select(name => Path.Combine(folder, name)))
        .FirstOrDefault(File.Exists);
}
