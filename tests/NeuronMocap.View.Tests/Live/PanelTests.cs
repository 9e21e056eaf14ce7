using NeuronMocap.Tests.Network;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.View;
using NeuronMocap.View.Tests.Infrastructure;

namespace NeuronMocap.View.Tests.Live;

// What a person does with the stream by its buttons.
public sealed class PanelTests(SharedBrowser browser) : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task A_second_click_on_follow_shows_all_again()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        const string Pressed = "pressed => document.querySelector(\"[data-id^='follow ']\").getAttribute('aria-pressed') === pressed";
        foreach (string pressed in (string[])["true", "false"])
        {
            await page.Page.Locator("[data-id^='follow ']").EvaluateAsync("button => button.click()");
            await page.UntilAsync(Pressed, pressed);
        }

        page.AssertClean();
    }

    [Fact]
    public async Task Keys_of_the_stream_do_nothing_while_a_file_is_shown()
    {
        await using RunningView view = await RunningView.StartAsync(Repository.PathOf("samples", "takes", "walk.bvh"));
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        await page.Page.Keyboard.PressAsync("r");
        await page.Page.Keyboard.PressAsync("g");

        // The keys before it were handled.
        await page.Page.Keyboard.PressAsync("?");
        await page.Page.Locator("dialog[open] .keys").WaitForAsync();
        Assert.DoesNotContain("Diagnose the stream", await page.Page.Locator("dialog[open]").InnerTextAsync(), StringComparison.Ordinal);
        Assert.Equal(0, await page.Page.Locator(".notice.problem").CountAsync());
        page.AssertClean();
    }

    [Fact]
    public async Task A_click_diagnoses_records_and_shows_the_recording()
    {
        await using RunningView view = await RunningView.StartAsync("demo", "--record-folder", _folder[string.Empty]);
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        await page.Page.Keyboard.PressAsync("p");
        await page.Page.GetByRole(AriaRole.Button, new() { Name = "Diagnose", Exact = true }).ClickAsync();
        await page.Page.Locator("dialog[open] pre").WaitForAsync();
        Assert.Contains("ok: ", await page.Page.Locator("dialog[open] pre").InnerTextAsync(), StringComparison.Ordinal);
        await page.Page.GetByRole(AriaRole.Button, new() { Name = "Close" }).ClickAsync();

        // The recording becomes a take, with its own time line.
        await page.Page.GetByRole(AriaRole.Button, new() { Name = "Record", Exact = true }).ClickAsync();
        await page.UntilAsync("() => /, [1-9]/.test(document.querySelector('.recording').textContent)");
        await page.Page.GetByRole(AriaRole.Button, new() { Name = "Stop the recording" }).ClickAsync();
        await page.Page.Locator(".finished").GetByRole(AriaRole.Button, new() { Name = "Show" }).ClickAsync();
        await page.UntilAsync("() => { const { mode, performers } = window.neuronMocap.state(); return mode === 'take' && performers[0]?.poses > 0; }");
        string file = Assert.Single(_folder.Names);
        Assert.EndsWith(".nmrec", file, StringComparison.Ordinal);
        Assert.Contains(file, await page.Page.Locator(".finished").InnerTextAsync(), StringComparison.Ordinal);
        page.AssertClean();
    }

    [Fact]
    public async Task A_recording_without_motion_is_offered_as_a_file_only()
    {
        await using RunningView view = await RunningView.StartAsync($"udp://127.0.0.1:{FreePort.Next()}", "--record-folder", _folder[string.Empty]);
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.Page.Keyboard.PressAsync("r");
        await page.UntilAsync("() => document.querySelector('.record-button').getAttribute('aria-pressed') === 'true'");
        await page.Page.Keyboard.PressAsync("r");
        await page.UntilAsync("() => document.querySelector('.finished small')?.textContent.endsWith(' · no motion')");

        Assert.Equal([".nmrec"], await page.Page.Locator(".finished button").EvaluateAllAsync<string[]>("buttons => buttons.map(button => button.textContent.trim())"));
        page.AssertClean();
    }
}
