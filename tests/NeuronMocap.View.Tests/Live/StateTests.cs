using System.Net;
using System.Net.Sockets;
using System.Text.Json;
using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tool.Tests.View;
using NeuronMocap.View.Tests.Infrastructure;

namespace NeuronMocap.View.Tests.Live;

// What the page says while there is no motion.
public sealed class StateTests(SharedBrowser browser)
{
    [Fact]
    public async Task Without_a_server_it_says_what_to_check_and_shows_the_stream_once_there_is_one()
    {
        int port = FreePort.Next();
        await using RunningView view = await RunningView.StartAsync($"127.0.0.1:{port}");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await AssertAdviceAsync(page, "connecting", "waiting");

        var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], BindAddress = IPAddress.Loopback, Port = port });
        await using (broadcaster)
        {
            broadcaster.Start();
            await page.UntilMovingAsync();
            await page.UntilAsync("() => document.querySelector('.overlay').hidden");
        }

        // The connection is lost. The figure stays where it was.
        await AssertAdviceAsync(page, "connecting", "waiting");
        Assert.True(await page.Page.Locator(".overlay.strip").IsVisibleAsync());
        page.AssertClean();
    }

    [Fact]
    public async Task A_server_that_sends_nothing_is_silent()
    {
        using var server = new TcpListener(IPAddress.Loopback, 0);
        server.Start();
        await using RunningView view = await RunningView.StartAsync(server.LocalEndpoint.ToString()!);
        using Socket connection = await server.AcceptSocketAsync(TestContext.Current.CancellationToken).AsTask().Soon();
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await AssertAdviceAsync(page, "connected", "silent");
        page.AssertClean();
    }

    [Fact]
    public async Task A_stream_without_performers_is_named_with_the_setting_to_change()
    {
        await using var broadcaster = new Broadcaster(new BroadcasterOptions
        {
            Sources = [new SyntheticSource()],
            BindAddress = IPAddress.Loopback,
            Port = 0,
            SendMotion = false,
            Calculation = static (_, _, values) => values.Clear(),
        });
        broadcaster.Start();
        await using RunningView view = await RunningView.StartAsync(broadcaster.LocalEndPoint!.ToString());
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await AssertAdviceAsync(page, "receiving");
        Assert.Contains("BVH", (await page.StateAsync()).GetProperty("advice").GetString(), StringComparison.Ordinal);
        page.AssertClean();
    }

    private static async Task AssertAdviceAsync(TestPage page, params string[] states)
    {
        await page.UntilAsync("states => { const { state, advice } = window.neuronMocap.state(); return states.includes(state) && advice !== ''; }", states);
        JsonElement state = await page.StateAsync();
        Assert.NotEmpty(state.GetProperty("title").GetString()!);
        await page.UntilAsync("() => { const box = document.querySelector('.overlay'); return !box.hidden && box.querySelector('.advice').textContent !== ''; }");
    }
}
