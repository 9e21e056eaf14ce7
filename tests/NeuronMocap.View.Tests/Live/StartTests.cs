using System.Globalization;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tool.Tests.View;
using NeuronMocap.View.Tests.Infrastructure;

namespace NeuronMocap.View.Tests.Live;

// A page that cannot start.
public sealed class StartTests(SharedBrowser browser)
{
    [Fact]
    public async Task A_page_without_its_scripts_says_so_and_loads_again_with_the_program()
    {
        string port = FreePort.Next().ToString(CultureInfo.InvariantCulture);
        RunningView view = await RunningView.StartAsync("demo", "--port", port);
        await using IBrowserContext context = await (await browser.StartAsync()).NewContextAsync();
        context.SetDefaultTimeout(TestPage.Patience);
        IPage page = await context.NewPageAsync();
        await page.RouteAsync("**/main-*.js", static route => route.AbortAsync());
        await page.GotoAsync(view.Link.ToString());
        await page.GetByText("This page is older than the program. Reload it.").WaitForAsync();
        await view.DisposeAsync();
        await page.GetByText("The program does not answer").WaitForAsync();
        await page.UnrouteAllAsync();

        await using RunningView again = await RunningView.StartAsync("demo", "--port", port);
        await page.WaitForFunctionAsync("() => window.neuronMocap?.state().performers.length === 1");
    }

    [Fact]
    public async Task A_browser_without_WebGL_is_told_what_it_lacks()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using IBrowserContext context = await (await browser.StartAsync()).NewContextAsync();
        context.SetDefaultTimeout(TestPage.Patience);
        await context.AddInitScriptAsync("HTMLCanvasElement.prototype.getContext = () => null;");
        IPage page = await context.NewPageAsync();
        await page.GotoAsync(view.Link.ToString());
        await page.GetByText("This browser cannot draw in three dimensions (WebGL 2).").WaitForAsync();
    }
}
