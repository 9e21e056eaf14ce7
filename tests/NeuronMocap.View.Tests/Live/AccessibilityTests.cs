using System.Text.Json;
using NeuronMocap.Tool.Tests.View;
using NeuronMocap.View.Tests.Infrastructure;

namespace NeuronMocap.View.Tests.Live;

// Everybody can use the page: on a phone, in both themes, and with the keyboard.
public sealed class AccessibilityTests(SharedBrowser browser)
{
    // Pixels from which the panel is open at first.
    private const int WidthOfPanel = 960;

    [Theory]
    [InlineData("demo", 390, 844, ColorScheme.Dark)]
    [InlineData("demo", 1000, 600, ColorScheme.Light)]
    [InlineData("take", 390, 844, ColorScheme.Light)]
    [InlineData("take", 1000, 600, ColorScheme.Dark)]
    public async Task Rules_of_accessibility_hold_and_nothing_is_wider_than_the_screen(string source, int width, int height, ColorScheme theme)
    {
        string axe = Repository.PathOf("web", "node_modules", "axe-core", "axe.min.js");
        Assert.SkipUnless(File.Exists(axe), "The packages of the folder web are not installed.");
        await using RunningView view = await RunningView.StartAsync(source == "take" ? Repository.PathOf("samples", "takes", "walk.bvh") : source);
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, width, height, theme);
        await page.UntilMovingAsync();
        JsonElement look = await page.EvaluateAsync("() => ({ theme: document.documentElement.dataset.theme, width: document.documentElement.scrollWidth })");
        Assert.Equal(theme == ColorScheme.Dark ? "dark" : "light", look.GetProperty("theme").GetString());
        Assert.InRange(look.GetProperty("width").GetInt32(), 1, width);

        // By the protocol of the browser, because the page itself allows no script of others.
        await page.EvaluateAsync($"() => {{ {await File.ReadAllTextAsync(axe, TestContext.Current.CancellationToken)}\n; return true; }}");
        await AssertRulesAsync(page);

        // On a phone, the panel covers a part of the stage.
        await PressAsync(page, "p");
        await page.UntilAsync("before => document.body.classList.contains('with-panel') !== before", width > WidthOfPanel);
        await AssertRulesAsync(page);
        Assert.InRange((await page.EvaluateAsync("() => document.documentElement.scrollWidth")).GetInt32(), 1, width);
        page.AssertClean();
    }

    [Fact]
    public async Task Keys_change_the_view_and_list_themselves()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, draws: true);
        await page.UntilMovingAsync();
        foreach ((string key, string setting) in ((string, string)[])[("a", "axes"), ("t", "trails"), ("m", "mirror")])
        {
            await PressAsync(page, key);
            Assert.True((await page.StateAsync()).GetProperty("settings").GetProperty(setting).GetBoolean(), setting);
            await page.UntilDrawnAsync();
        }

        await PressAsync(page, "b");
        Assert.Equal("sticks", (await page.StateAsync()).GetProperty("settings").GetProperty("look").GetString());
        await page.UntilDrawnAsync();
        await PressAsync(page, "?");
        await page.Page.Locator("dialog[open]").WaitForAsync();
        await PressAsync(page, "Escape");
        await page.UntilAsync("() => document.querySelector('dialog[open]') === null");

        // Everything that has the focus has a name.
        for (int i = 0; i < 12; i++)
        {
            await PressAsync(page, "Tab");
            Assert.NotEmpty((await page.EvaluateAsync("() => document.activeElement.getAttribute('aria-label') ?? document.activeElement.textContent")).GetString()!);
        }

        page.AssertClean();
    }

    private static async Task AssertRulesAsync(TestPage page)
    {
        JsonElement violations = await page.EvaluateAsync("""
            async () => (await axe.run(document, { resultTypes: ["violations"] })).violations
              .filter(each => each.impact === "serious" || each.impact === "critical")
              .map(each => `${each.id}: ${each.nodes.map(node => node.html).join(" ")}`)
            """);
        Assert.Empty(violations.EnumerateArray().Select(static each => each.GetString()));
    }

    private static Task PressAsync(TestPage page, string key) => page.Page.Keyboard.PressAsync(key);
}
