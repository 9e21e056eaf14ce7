using System.Text.Json;
using System.Text.Json.Nodes;
using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Tests.View;
using NeuronMocap.View.Tests.Infrastructure;

namespace NeuronMocap.View.Tests.Takes;

// Takes on the page.
public sealed class TakePageTests(SharedBrowser browser)
{
    private const float Rounding = 0.001f;

    // Frames.
    private const int PartLength = 6;

    // The earliest time that is shown while the time goes back three times.
    private const string ThreeRounds = """
        key => new Promise(resolve => {
          let [rounds, earliest, last] = [0, Infinity, -Infinity];
          const look = () => {
            const now = window.neuronMocap.time(key);
            if (now < last)
              rounds++;
            [earliest, last] = [Math.min(earliest, now), now];
            if (rounds < 3)
              requestAnimationFrame(look);
            else
              resolve(earliest);
          };
          look();
        })
        """;

    private static readonly string Walk = Repository.PathOf("samples", "takes", "walk.bvh");

    [Fact]
    public async Task A_chosen_take_plays_and_steps_with_the_joints_of_the_file()
    {
        var source = new BvhSource(BvhDocument.Load(Walk));
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, 640, 480, draws: true);
        await page.UntilMovingAsync();
        await page.ChooseAsync(() => page.Page.Keyboard.PressAsync("o"), Walk);
        await UntilShownAsync(page);
        await AssertJointsAsync(page, source, 0);

        // Steps.
        await page.Page.Keyboard.PressAsync(".");
        await page.Page.Keyboard.PressAsync(".");
        await AssertJointsAsync(page, source, 2);
        await page.Page.Keyboard.PressAsync(",");
        await AssertJointsAsync(page, source, 1);
        await page.Page.Keyboard.PressAsync("End");
        await AssertJointsAsync(page, source, (int)source.FrameCount!.Value - 1);

        // The part from here to the end is played again and again.
        for (int i = 0; i < PartLength; i++)
            await page.Page.Keyboard.PressAsync(",");
        await AssertJointsAsync(page, source, (int)source.FrameCount.Value - 1 - PartLength);
        await page.Page.Keyboard.PressAsync("[");
        if (!await IsPressedAsync(page, "Loop"))
            await page.Page.Keyboard.PressAsync("l");
        Assert.True(await IsPressedAsync(page, "Loop"));
        await page.Page.Keyboard.PressAsync("Space");
        await page.Page.Locator("[aria-label=Stop]").WaitForAsync();
        JsonElement earliest = await page.EvaluateAsync(ThreeRounds, await KeyAsync(page));

        // A slow computer draws few pictures in a round, and none may be that of its begin.
        double last = source.FrameCount.Value - 1;
        Assert.InRange(earliest.GetDouble() / 1000 * source.FrameRate, last - PartLength - 0.5, last);
        await page.Page.Keyboard.PressAsync("Space");
        await page.Page.Locator("[aria-label=Play]").WaitForAsync();
        page.AssertClean();
    }

    [Fact]
    public async Task A_download_holds_the_part_between_the_in_and_out_points()
    {
        const int From = 10, To = 20;
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, 1280, 800);
        await page.ChooseAsync(() => page.Page.Keyboard.PressAsync("o"), Walk);
        await UntilShownAsync(page);
        for (int i = 0; i < To; i++)
        {
            await page.Page.Keyboard.PressAsync(".");
            if (i == From - 1)
                await page.Page.Keyboard.PressAsync("[");
        }

        await page.Page.Keyboard.PressAsync("]");
        await page.Page.GetByText("Downloads hold the part from").WaitForAsync();
        BvhDocument part = await DownloadAsync(page), whole = BvhDocument.Load(Walk);
        Assert.Equal(To - From, part.FrameCount);
        Assert.Equal(whole.GetValues(From).ToArray(), part.GetValues(0).ToArray());

        await page.Page.Keyboard.PressAsync("x");
        Assert.Equal(whole.FrameCount, (await DownloadAsync(page)).FrameCount);
        page.AssertClean();
    }

    [Fact]
    public async Task A_recording_that_the_program_still_reads_begins_at_its_first_frame()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        bool isFirst = true;
        await page.Page.RouteAsync("**/api/takes/*", async route =>
        {
            if (!isFirst)
            {
                await route.ContinueAsync();
                return;
            }

            IAPIResponse answer = await route.FetchAsync();
            JsonNode take = JsonNode.Parse(await answer.TextAsync())!;
            if (take["performers"]!.AsArray().FirstOrDefault() is not { } performer)
            {
                await route.FulfillAsync(new RouteFulfillOptions { Response = answer });
                return;
            }

            // The program has found the performer, and no frame yet.
            isFirst = false;
            take["progress"] = 0.5;
            foreach (string name in (string[])["frames", "start", "end"])
                performer[name] = 0;
            await route.FulfillAsync(new RouteFulfillOptions { Response = answer, Body = take.ToJsonString() });
        });
        string path = Repository.PathOf("samples", "takes", "walk.nmrec");
        await page.DropAsync("walk.nmrec", await File.ReadAllBytesAsync(path, TestContext.Current.CancellationToken));
        await AssertJointsAsync(page, RecordingSource.Load(path), 0);
        Assert.False(isFirst);
        page.AssertClean();
    }

    [Fact]
    public async Task A_dropped_recording_is_shown_and_a_foreign_file_is_refused_in_a_sentence()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        await page.DropAsync("picture.txt", [1, 2, 3]);
        await page.UntilAsync("() => document.querySelector('.notice.problem')?.textContent.includes('picture.txt')");
        string path = Repository.PathOf("samples", "takes", "walk.nmrec");
        await page.DropAsync("walk.nmrec", await File.ReadAllBytesAsync(path, TestContext.Current.CancellationToken));
        await UntilShownAsync(page);
        await AssertJointsAsync(page, RecordingSource.Load(path), 0);
        page.AssertClean(IsRefusal);
    }

    [Fact]
    public async Task A_take_whose_upload_ends_late_waits_for_a_click()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        byte[] walk = await File.ReadAllBytesAsync(Walk, TestContext.Current.CancellationToken);
        Func<Task> endUpload = await HoldAsync(page, "/api/takes?name=first.bvh", () => page.DropAsync("first.bvh", walk));
        await page.DropAsync("second.bvh", walk);
        await UntilShownAsync(page);
        string second = await TakeAsync(page);
        await endUpload();
        await page.Page.GetByText("first.bvh is ready.").WaitForAsync();
        Assert.Equal(second, await TakeAsync(page));

        await page.Page.GetByRole(AriaRole.Button, new PageGetByRoleOptions { Name = "Show", Exact = true }).ClickAsync();
        await page.UntilAsync("second => window.neuronMocap.state().take !== second", second);
        await UntilShownAsync(page);
        page.AssertClean();
    }

    [Fact]
    public async Task A_file_that_cannot_be_opened_does_not_replace_the_take_before_it()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        byte[] walk = await File.ReadAllBytesAsync(Walk, TestContext.Current.CancellationToken);
        Func<Task> endUpload = await HoldAsync(page, "/api/takes?name=first.bvh", () => page.DropAsync("first.bvh", walk));
        await page.DropAsync("damaged.bvh", [1, 2, 3]);
        await page.UntilAsync("() => document.querySelector('.notice.problem')?.textContent.includes('damaged.bvh')");
        await endUpload();
        await UntilShownAsync(page);
        page.AssertClean(IsRefusal);
    }

    [Fact]
    public async Task Of_two_takes_the_one_that_was_chosen_last_is_shown()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        byte[] walk = await File.ReadAllBytesAsync(Walk, TestContext.Current.CancellationToken);
        Func<Task> answer = await HoldAsync(page, "/api/takes/", () => page.DropAsync("first.bvh", walk));
        await page.DropAsync("second.bvh", walk);
        await UntilShownAsync(page);
        string second = await TakeAsync(page);
        await page.Page.RunAndWaitForResponseAsync(
            answer, response => response.Url.Contains("/api/takes/", StringComparison.Ordinal) && !response.Url.Contains(second, StringComparison.Ordinal));
        await page.EvaluateAsync("() => new Promise(requestAnimationFrame)");
        Assert.Equal(second, await TakeAsync(page));
        page.AssertClean();
    }

    [Fact]
    public async Task After_a_click_on_a_button_the_space_bar_plays_the_take()
    {
        await using RunningView view = await RunningView.StartAsync(Walk);
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, 640, 480);
        await UntilShownAsync(page);
        await page.Page.Keyboard.PressAsync(".");
        await page.Page.GetByRole(AriaRole.Button, new PageGetByRoleOptions { Name = "Start of the part", Exact = true }).ClickAsync();
        await page.Page.Keyboard.PressAsync("Space");
        await page.Page.Locator("[aria-label=Stop]").WaitForAsync();
        page.AssertClean();
    }

    [Fact]
    public async Task A_name_stays_above_a_performer_who_stands_still_when_the_picture_changes_its_size()
    {
        await using RunningView view = await RunningView.StartAsync(Walk);
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await UntilShownAsync(page);
        const string IsAtMiddle = """
            width => {
              const name = document.querySelector(".label").getBoundingClientRect();
              return innerWidth === width && name.width > 0 && Math.abs(name.left + name.width / 2 - width / 2) < 30;
            }
            """;
        await page.UntilAsync(IsAtMiddle, 480);
        await page.Page.SetViewportSizeAsync(700, 400);
        await page.UntilAsync(IsAtMiddle, 700);
        page.AssertClean();
    }

    private static async Task<BvhDocument> DownloadAsync(TestPage page)
    {
        IDownload download = await page.Page.RunAndWaitForDownloadAsync(
            () => page.Page.GetByRole(AriaRole.Button, new PageGetByRoleOptions { Name = "BVH", Exact = true }).ClickAsync());
        return BvhDocument.Load(await download.PathAsync());
    }

    private static Task UntilShownAsync(TestPage page) => page.UntilAsync(
        "() => { const { mode, take, performers } = window.neuronMocap.state(); return mode === 'take' && take !== null && performers.length === 1 && performers[0].hasFigure && performers[0].poses > 0; }");

    private static async Task<string> KeyAsync(TestPage page) => (await page.EvaluateAsync("() => window.neuronMocap.state().performers[0].key")).GetString()!;

    private static async Task<string> TakeAsync(TestPage page) => (await page.StateAsync()).GetProperty("take").GetString()!;

    // The browser itself reports a refused request.
    private static bool IsRefusal(string fault) =>
        fault.Contains("Failed to load resource", StringComparison.Ordinal) && fault.Contains(" 400 ", StringComparison.Ordinal);

    // Holds the first request that an action causes. Returns what lets it go on.
    private static async Task<Func<Task>> HoldAsync(TestPage page, string address, Func<Task> action)
    {
        var held = new TaskCompletionSource<IRoute>(TaskCreationOptions.RunContinuationsAsynchronously);
        await page.Page.RouteAsync(url => url.Contains(address, StringComparison.Ordinal), held.SetResult, new PageRouteOptions { Times = 1 });
        await action();
        IRoute request = await held.Task;
        return () => request.ContinueAsync();
    }

    private static async Task<bool> IsPressedAsync(TestPage page, string name) =>
        await page.Page.Locator($"[aria-label={name}]").GetAttributeAsync("aria-pressed") == "true";

    private static async Task AssertJointsAsync(TestPage page, MotionSource source, int frame)
    {
        string words = $"frame {frame + 1} of {source.FrameCount}";
        await page.UntilAsync("words => document.querySelector('.readout .frame')?.textContent === words", words);
        string key = await KeyAsync(page);
        JsonElement joints = await page.EvaluateAsync("key => new Promise(resolve => requestAnimationFrame(() => resolve(window.neuronMocap.joints(key))))", key);
        var world = new BoneTransform[BoneHierarchy.BoneCount];
        source.GetPose(frame, world);
        ForwardKinematics.ToWorld(world, world, source.Variant);
        Assert.InRange(Joints.Distance(joints, world), 0, Rounding);
    }
}
