using System.Collections.Concurrent;
using System.Text.Json;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Tests.View;
using NeuronMocap.View.Tests.Infrastructure;

namespace NeuronMocap.View.Tests.Live;

// The live stream on the page.
public sealed class LivePageTests(SharedBrowser browser)
{
    // Rotations are rounded to 0.009 degrees, which is a millimetre at most from the hips to a fingertip.
    private const float Rounding = 0.001f;

    [Fact]
    public async Task Three_performers_stand_where_the_library_places_them()
    {
        await using Broadcaster broadcaster = Broadcaster.StartDemo(3);
        var frames = new ConcurrentDictionary<(int Avatar, uint Frame), BoneTransform[]>();
        await using var reader = new NeuronReader("127.0.0.1", broadcaster.LocalEndPoint!.Port);
        reader.MotionReceived += frame =>
        {
            var world = new BoneTransform[BoneHierarchy.BoneCount];
            frame.CopyWorldTransforms(world);
            frames[(frame.AvatarIndex, frame.FrameIndex ?? 0)] = world;
        };
        reader.Start();
        await Limits.UntilAsync(() => frames.Count > 3);
        await using RunningView view = await RunningView.StartAsync($"127.0.0.1:{broadcaster.LocalEndPoint.Port}");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, draws: true);
        await page.UntilMovingAsync(3);
        JsonElement shown = await page.EvaluateAsync("""
            () => new Promise(resolve => requestAnimationFrame(() => {
              const { state, frame, joints, figure } = window.neuronMocap;
              resolve(state().performers.map(({ key, name }) => ({ key, name, frame: frame(key), joints: joints(key), figure: figure(key) })));
            }))
            """);
        Assert.Equal(["Demo 1", "Demo 2", "Demo 3"], shown.EnumerateArray().Select(static each => each.GetProperty("name").GetString()));
        foreach (JsonElement performer in shown.EnumerateArray())
        {
            int avatar = int.Parse(performer.GetProperty("key").GetString()!.Split('-')[1], System.Globalization.CultureInfo.InvariantCulture);
            (int, uint) moment = (avatar, performer.GetProperty("frame").GetUInt32());
            await Limits.UntilAsync(() => frames.ContainsKey(moment));
            Assert.InRange(Joints.Distance(performer.GetProperty("joints"), frames[moment]), 0, Rounding);
            Assert.InRange(Joints.Distance(performer.GetProperty("figure"), frames[moment]), 0, Rounding);
        }

        JsonElement stats = await page.EvaluateAsync("() => window.neuronMocap.stats()");
        Assert.InRange(stats.GetProperty("receivedBytes").GetDouble() / stats.GetProperty("received").GetDouble(), 1, 500);
        page.AssertClean();
    }

    // A canvas with an alpha channel is blended with the page at every picture.
    [Fact]
    public async Task The_canvas_is_opaque()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        Assert.False((await page.EvaluateAsync("() => document.querySelector('canvas').getContext('webgl2').getContextAttributes().alpha")).GetBoolean());
    }

    [Fact]
    public async Task It_connects_again_when_the_program_returns()
    {
        RunningView view = await RunningView.StartAsync("demo");
        TestPage page;
        await using (view)
        {
            page = await TestPage.OpenAsync(browser, view.Link);
            await page.UntilMovingAsync();
        }

        await using (page)
        {
            await page.UntilAsync("() => window.neuronMocap.state().connection === 'gone'");
            JsonElement state = await page.StateAsync();
            Assert.Equal("The program does not answer", state.GetProperty("title").GetString());
            Assert.Contains("start it again", state.GetProperty("advice").GetString(), StringComparison.Ordinal);
            double before = await PosesAsync(page);
            await page.Page.Keyboard.PressAsync("r");
            ILocator notice = page.Page.Locator(".notice").GetByText("The program does not answer.");
            await notice.WaitForAsync();
            await using RunningView again = await RunningView.StartAsync("demo", "--port", $"{view.Link.Port}");
            await page.UntilAsync("before => { const { connection, performers } = window.neuronMocap.state(); return connection === 'open' && performers[0]?.poses > before + 2; }", before);
            Assert.Equal(0, await notice.CountAsync());
            page.AssertClean(IsOfConnection);
        }
    }

    [Fact]
    public async Task A_hidden_tab_closes_its_sockets()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        Assert.Contains("/motion", page.OpenSockets);
        await SetHiddenAsync(page, hidden: true);
        await Limits.UntilAsync(() => !page.OpenSockets.Any());
        Assert.Equal("hidden", (await page.StateAsync()).GetProperty("connection").GetString());
        double before = await PosesAsync(page);
        await SetHiddenAsync(page, hidden: false);
        await page.UntilAsync("before => window.neuronMocap.state().performers[0]?.poses > before + 2", before);
        page.AssertClean();
    }

    [Fact]
    public async Task Two_browsers_show_the_same_performer()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage first = await TestPage.OpenAsync(browser, view.Link, 320, 320);
        await using TestPage second = await TestPage.OpenAsync(browser, view.Link, 320, 320);
        await first.UntilMovingAsync();
        await second.UntilMovingAsync();
        await first.Page.CloseAsync();
        double before = await PosesAsync(second);
        await second.UntilAsync("before => window.neuronMocap.state().performers[0].poses > before + 2", before);
        second.AssertClean();
    }

    [Fact]
    public async Task A_wrong_token_shows_where_the_link_is()
    {
        await using RunningView view = await RunningView.StartAsync("demo", "--token", "right");
        await using (TestPage wrong = await TestPage.OpenAsync(browser, new Uri(view.Link, "/?token=wrong")))
        {
            await wrong.UntilAsync("() => window.neuronMocap.state().connection === 'denied'");
            Assert.Contains("Open the link", (await wrong.StateAsync()).GetProperty("advice").GetString(), StringComparison.Ordinal);
            wrong.AssertClean(IsOfConnection);
        }

        await using TestPage right = await TestPage.OpenAsync(browser, view.Link);
        await right.UntilMovingAsync();
        Assert.DoesNotContain("token", right.Page.Url, StringComparison.Ordinal);
        right.AssertClean();
    }

    private static async Task<double> PosesAsync(TestPage page) =>
        (await page.EvaluateAsync("() => window.neuronMocap.state().performers[0]?.poses ?? 0")).GetDouble();

    private static Task<JsonElement> SetHiddenAsync(TestPage page, bool hidden) => page.EvaluateAsync(
        "hidden => { Object.defineProperty(document, 'hidden', { configurable: true, get: () => hidden }); document.dispatchEvent(new Event('visibilitychange')); return true; }",
        hidden);

    // The browser itself reports requests that fail.
    private static bool IsOfConnection(string fault) =>
        fault.Contains("Failed to load resource", StringComparison.Ordinal) || fault.Contains("WebSocket connection to", StringComparison.Ordinal);
}
