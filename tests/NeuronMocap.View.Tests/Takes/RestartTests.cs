using System.Globalization;
using System.Text.Json;
using NeuronMocap.Bvh;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tool.Tests.View;
using NeuronMocap.View.Tests.Infrastructure;

namespace NeuronMocap.View.Tests.Takes;

// The program is started again while a page is open.
public sealed class RestartTests(SharedBrowser browser) : IDisposable
{
    private static readonly string Walk = Repository.PathOf("samples", "takes", "walk.bvh");

    private readonly string _other = Path.Combine(Path.GetTempPath(), $"{Guid.NewGuid():N}.bvh");

    public void Dispose() => File.Delete(_other);

    [Fact]
    public async Task The_page_says_that_a_dropped_take_is_gone_and_shows_the_stream()
    {
        string port = FreePort.Next().ToString(CultureInfo.InvariantCulture);
        RunningView view = await RunningView.StartAsync("demo", "--port", port);
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        await page.ChooseAsync(() => page.Page.Keyboard.PressAsync("o"), Walk);
        await UntilTakeAsync(page);
        await view.DisposeAsync();
        await page.UntilAsync("() => window.neuronMocap.state().connection === 'gone'");

        await using RunningView again = await RunningView.StartAsync("demo", "--port", port);
        await page.Page.GetByText("This take is not open any more. Drop its file on the page again.").WaitForAsync();
        await page.UntilAsync("() => window.neuronMocap.state().mode === 'live'");
        await page.UntilMovingAsync();
        page.AssertClean(IsOfRestart);
    }

    [Fact]
    public async Task The_page_shows_the_take_of_the_new_program_and_not_frames_of_both()
    {
        string port = FreePort.Next().ToString(CultureInfo.InvariantCulture);
        RunningView view = await RunningView.StartAsync(Walk, "--port", port);
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        JsonElement before = await UntilTakeAsync(page);
        await view.DisposeAsync();
        await page.UntilAsync("() => window.neuronMocap.state().connection === 'gone'");

        BvhDocument.Load(Walk).Trim(0, 12).Save(_other);
        await using RunningView again = await RunningView.StartAsync(_other, "--port", port);
        await page.UntilAsync("take => { const state = window.neuronMocap.state(); return state.take !== take && state.performers.length === 1 && state.performers[0].poses > 0; }", before.GetString());
        await page.Page.Locator(".readout .frame", new PageLocatorOptions { HasTextString = "of 12" }).WaitForAsync();
        page.AssertClean(IsOfRestart);
    }

    [Fact]
    public async Task Performers_that_the_new_program_does_not_have_leave_the_picture()
    {
        string port = FreePort.Next().ToString(CultureInfo.InvariantCulture);
        RunningView view = await RunningView.StartAsync("demo", "--port", port);
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        await view.DisposeAsync();
        await page.UntilAsync("() => window.neuronMocap.state().connection === 'gone'");
        const string StandsStill = """
            () => new Promise(resolve => {
              const { pictures } = window.neuronMocap.stats();
              setTimeout(() => resolve(window.neuronMocap.stats().pictures === pictures), 500);
            })
            """;
        await page.UntilAsync(StandsStill);
        int before = (await page.EvaluateAsync("() => window.neuronMocap.stats().pictures")).GetInt32();

        await using RunningView again = await RunningView.StartAsync($"127.0.0.1:{FreePort.Next()}", "--port", port);
        await page.UntilAsync("pictures => window.neuronMocap.state().performers.length === 0 && window.neuronMocap.stats().pictures > pictures", before);
        page.AssertClean(IsOfRestart);
    }

    [Fact]
    public async Task A_page_of_the_stream_shows_the_file_that_the_new_program_shows()
    {
        string port = FreePort.Next().ToString(CultureInfo.InvariantCulture);
        RunningView view = await RunningView.StartAsync("demo", "--port", port);
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        await view.DisposeAsync();
        await page.UntilAsync("() => window.neuronMocap.state().connection === 'gone'");

        await using RunningView again = await RunningView.StartAsync(Walk, "--port", port);
        await UntilTakeAsync(page);
        page.AssertClean(IsOfRestart);
    }

    // The browser reports every request that fails.
    private static bool IsOfRestart(string fault) =>
        fault.Contains("Failed to load resource", StringComparison.Ordinal) || fault.Contains("WebSocket connection", StringComparison.Ordinal);

    private static async Task<JsonElement> UntilTakeAsync(TestPage page)
    {
        await page.UntilAsync("() => { const { mode, take, performers } = window.neuronMocap.state(); return mode === 'take' && take !== null && performers.length === 1 && performers[0].poses > 0; }");
        return (await page.StateAsync()).GetProperty("take");
    }
}
