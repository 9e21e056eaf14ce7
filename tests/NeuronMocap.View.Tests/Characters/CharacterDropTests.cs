using System.Globalization;
using System.Net;
using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.View;
using NeuronMocap.View.Tests.Infrastructure;

namespace NeuronMocap.View.Tests.Characters;

// Dropping and removing characters.
public sealed class CharacterDropTests(SharedBrowser browser, CharacterSamples samples)
{
    private const int Drops = 3;

    private static readonly string Walk = Repository.PathOf("samples", "takes", "walk.bvh");

    [Theory]
    [InlineData("boxes-1.vrm")]
    [InlineData("boxes-z-up.glb")]
    public async Task Removed_characters_leave_nothing_on_the_graphics_card(string file)
    {
        await using RunningView view = await RunningView.StartAsync(Walk);
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, 320, 240, draws: true);
        await page.UntilMovingAsync();
        byte[] contents = await samples.ReadAsync(file);
        await DropAndRemoveAsync(page, file, contents);
        string before = await MemoryAsync(page);
        for (int i = 0; i < Drops; i++)
            await DropAndRemoveAsync(page, file, contents);

        Assert.Equal(before, await MemoryAsync(page));
        page.AssertClean();
    }

    [Fact]
    public async Task Characters_that_are_dropped_together_wait_for_a_performer_and_stand_side_by_side()
    {
        int port = FreePort.Next();
        await using RunningView view = await RunningView.StartAsync(string.Create(CultureInfo.InvariantCulture, $"127.0.0.1:{port}"));
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, 1280, 400);
        await page.UntilAsync("() => window.neuronMocap.state().connection === 'open'");
        await page.DropAsync(("boxes-1.vrm", await samples.ReadAsync("boxes-1.vrm")), ("boxes-mixamo.glb", await samples.ReadAsync("boxes-mixamo.glb")));
        await page.UntilAsync("() => window.neuronMocap.state().characters.length === 2");
        Assert.Equal(2, await page.Page.GetByText("No performer yet").CountAsync() - await page.Page.Locator(".overlay").GetByText("No performer yet").CountAsync());

        await using var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], BindAddress = IPAddress.Loopback, Port = port });
        broadcaster.Start();
        await page.UntilAsync("() => { const { characters } = window.neuronMocap.state(); return characters.every(each => each.isShown) && characters[0].place !== characters[1].place; }");
        page.AssertClean();
    }

    // A take brings its performers one at a time.
    [Theory]
    [InlineData(2)]
    [InlineData(1)]
    public async Task Two_characters_find_the_performers_of_a_take(int performers)
    {
        await using Broadcaster broadcaster = Broadcaster.StartDemo(2);
        await using RunningView view = await RunningView.StartAsync(broadcaster.LocalEndPoint!.ToString());
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync(2);
        await page.DropAsync(("boxes-1.vrm", await samples.ReadAsync("boxes-1.vrm")), ("boxes-mixamo.glb", await samples.ReadAsync("boxes-mixamo.glb")));
        await page.UntilAsync(AreApart, 2);

        using var folder = new TemporaryFolder();
        await RecordAsync(performers, folder["take.nmrec"]);
        await page.ChooseAsync(() => page.Page.Keyboard.PressAsync("o"), folder["take.nmrec"]);
        await page.UntilAsync("() => window.neuronMocap.state().mode === 'take'");
        await page.UntilMovingAsync(performers);
        await page.UntilAsync(AreApart, performers);
        page.AssertClean();
    }

    [Fact]
    public async Task A_character_that_changes_its_performer_moves_no_other()
    {
        await using Broadcaster broadcaster = Broadcaster.StartDemo(2);
        await using RunningView view = await RunningView.StartAsync(broadcaster.LocalEndPoint!.ToString());
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync(2);
        await page.DropAsync(("boxes-1.vrm", await samples.ReadAsync("boxes-1.vrm")), ("boxes-mixamo.glb", await samples.ReadAsync("boxes-mixamo.glb")));
        await page.UntilAsync(AreApart, 2);
        string other = (await page.StateAsync()).GetProperty("characters")[1].GetProperty("performer").GetString()!;
        await page.EvaluateAsync("""
            other => {
              const choice = document.querySelector("[data-id='performer 0']");
              choice.value = other;
              choice.dispatchEvent(new Event("change"));
            }
            """, other);
        await page.UntilAsync("other => window.neuronMocap.state().characters.every(each => each.performer === other && each.isShown)", other);
        await page.UntilAsync(AreApart, 1);
        page.AssertClean();
    }

    [Fact]
    public async Task A_page_that_lacks_a_script_because_the_program_is_newer_says_so()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, 320, 240);
        await page.UntilMovingAsync();
        await page.Page.RouteAsync("**/load-*.js", static route => route.FulfillAsync(new RouteFulfillOptions { Status = 404 }));
        await page.DropAsync("boxes-1.vrm", await samples.ReadAsync("boxes-1.vrm"));
        await page.Page.GetByText("This page is older than the program. Reload it.").WaitForAsync();
        page.AssertClean(static fault => fault.Contains("404", StringComparison.Ordinal));
    }

    [Fact]
    public async Task An_empty_file_and_a_picture_with_another_name_are_refused_in_a_sentence()
    {
        byte[] picture = await samples.ReadAsync("boxes.png");
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        foreach ((string name, byte[] contents, string words) in ((string, byte[], string)[])
        [
            ("empty.vrm", [], "empty.vrm is empty."),
            ("picture.glb", picture, "picture.glb is not a glTF or VRM file."),
            ("empty.bvh", [], "empty.bvh"),
            ("picture.nmrec", picture, "picture.nmrec"),
        ])
        {
            await page.DropAsync(name, contents);
            await page.Page.Locator(".notice.problem").GetByText(words).WaitForAsync();
        }

        page.AssertClean(static fault => fault.Contains(" 400 ", StringComparison.Ordinal));
    }

    private const string AreApart = """
        performers => {
          const { characters } = window.neuronMocap.state();
          return characters.length === 2 && characters.every(each => each.isShown)
            && new Set(characters.map(each => each.performer)).size === performers
            && new Set(characters.map(each => `${each.performer} ${each.place}`)).size === 2;
        }
        """;

    private static async Task RecordAsync(int performers, string path)
    {
        await using Broadcaster broadcaster = Broadcaster.StartDemo(performers);
        await using var reader = new NeuronReader(broadcaster.LocalEndPoint!.Address.ToString(), broadcaster.LocalEndPoint.Port);
        reader.StartRecording(path);
        reader.Start();
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames >= 60);
    }

    private static async Task DropAndRemoveAsync(TestPage page, string file, byte[] contents)
    {
        await page.DropAsync(file, contents);
        await page.UntilAsync("() => { const { characters } = window.neuronMocap.state(); return characters.length === 1 && characters[0].isShown; }");
        await DrawAsync(page);
        await page.Page.Locator($"[aria-label='Remove {file}']").EvaluateAsync("button => button.click()");
        await page.UntilAsync("() => window.neuronMocap.state().characters.length === 0");
        await DrawAsync(page);
    }

    // What is not drawn is not on the graphics card. A step makes the page draw.
    private static async Task DrawAsync(TestPage page)
    {
        int pictures = await PicturesAsync(page);
        await page.Page.Keyboard.PressAsync(".");
        await page.UntilAsync("pictures => window.neuronMocap.stats().pictures > pictures", pictures);
    }

    private static async Task<int> PicturesAsync(TestPage page) => (await page.EvaluateAsync("() => window.neuronMocap.stats().pictures")).GetInt32();

    private static async Task<string> MemoryAsync(TestPage page) => (await page.EvaluateAsync("() => window.neuronMocap.stats().memory")).ToString();
}
