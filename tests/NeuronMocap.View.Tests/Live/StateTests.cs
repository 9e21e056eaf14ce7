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

    [Theory]
    [InlineData("", "The address has no token")]
    [InlineData("?token=old", "The token is not that of the running program")]
    public async Task A_link_without_the_token_is_explained_once(string query, string reason)
    {
        await using RunningView view = await RunningView.StartAsync("demo", "--token", "secret", "--bind", "0.0.0.0");
        await using TestPage page = await TestPage.OpenAsync(browser, new Uri(new Uri(view.Link, "/"), query), 1280, 800);
        await page.UntilAsync("() => window.neuronMocap.state().connection === 'denied'");
        ILocator reasons = page.Page.GetByText(reason);
        await page.Page.Locator(".overlay").GetByText(reason).WaitForAsync();
        await page.Page.Locator(".overlay").GetByText("Open the link that neuron-mocap view shows in its terminal").WaitForAsync();
        int shown = 0;
        foreach (ILocator one in await reasons.AllAsync())
            shown += await one.IsVisibleAsync() ? 1 : 0;

        Assert.Equal(1, shown);
        // What would only fail is not offered.
        Assert.False(await page.Page.GetByRole(AriaRole.Button, new PageGetByRoleOptions { Name = "Record" }).IsVisibleAsync());
        Assert.False(await page.Page.GetByRole(AriaRole.Button, new PageGetByRoleOptions { Name = "Open file" }).IsVisibleAsync());
        // The browser does not always tell the status of a socket that is refused.
        page.AssertClean(static fault => fault.Contains("401", StringComparison.Ordinal) || fault.Contains("WebSocket connection", StringComparison.Ordinal));
    }

    private static async Task AssertAdviceAsync(TestPage page, params string[] states)
    {
        await page.UntilAsync("states => { const { state, advice } = window.neuronMocap.state(); return states.includes(state) && advice !== ''; }", states);
        JsonElement state = await page.StateAsync();
        Assert.NotEmpty(state.GetProperty("title").GetString()!);
        await page.UntilAsync("() => { const box = document.querySelector('.overlay'); return !box.hidden && box.querySelector('.advice').textContent !== ''; }");
    }
}
