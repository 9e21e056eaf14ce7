using NeuronMocap.Tool.Tests.View;
using NeuronMocap.View.Tests.Infrastructure;

namespace NeuronMocap.View.Tests.Characters;

// Characters dropped on the page.
public sealed class CharacterPageTests(SharedBrowser browser, CharacterSamples samples)
{
    [Fact]
    public async Task A_figure_of_the_library_moves_like_its_performer()
    {
        await using RunningView view = await RunningView.StartAsync(Repository.PathOf("samples", "takes", "walk.bvh"));
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, draws: true);
        await page.UntilMovingAsync();
        string id = (await page.StateAsync()).GetProperty("take").GetString()!;
        string key = (await page.StateAsync()).GetProperty("performers")[0].GetProperty("key").GetString()!;
        byte[] figure = await view.Client.GetByteArrayAsync($"/api/takes/{id}/performers/{key}/figure.glb", TestContext.Current.CancellationToken);
        await page.DropAsync("figure.glb", figure);
        await UntilShownAsync(page);
        await LetFeetSlideAsync(page);
        foreach ((string press, int frame) in ((string, int)[])[("End", Frames), ("Home", 1)])
        {
            await GoAsync(page, press, frame);

            // Poses of characters come in chunks of their own.
            await page.UntilAsync("""
                key => {
                  const { state, joints, character } = window.neuronMocap;
                  const [own, other] = [joints(key), character(state().characters[0].id)];
                  return Object.keys(other).length > 50 && Object.entries(other).every(([name, place]) => Math.hypot(...place.map((each, i) => each - own[name][i])) < 0.002);
                }
                """, key);
        }

        page.AssertClean();
    }

    [Theory]
    [InlineData("boxes-1.vrm")]
    [InlineData("boxes-0.vrm")]
    [InlineData("boxes-mixamo.glb")]
    [InlineData("boxes-z-up.glb")]
    public async Task A_character_holds_its_limbs_like_the_performer(string file)
    {
        await using RunningView view = await RunningView.StartAsync(Repository.PathOf("samples", "takes", "walk.bvh"));
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, draws: true);
        await page.UntilMovingAsync();
        await page.DropAsync(file, await samples.ReadAsync(file));
        await UntilShownAsync(page);
        await LetFeetSlideAsync(page);
        foreach ((string key, int frame) in ((string, int)[])[("End", Frames), ("Home", 1)])
        {
            await GoAsync(page, key, frame);
            await page.UntilAsync(IsLike, Limbs);
        }

        page.AssertClean();
    }

    [Fact]
    public async Task A_character_is_hidden_with_its_performer()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        await page.DropAsync("boxes-1.vrm", await samples.ReadAsync("boxes-1.vrm"));
        await UntilShownAsync(page);
        foreach (bool isShown in (bool[])[false, true])
        {
            await page.Page.Locator("[data-id^='hide ']").EvaluateAsync("button => button.click()");
            await page.UntilAsync("isShown => window.neuronMocap.state().characters[0].isShown === isShown", isShown);
        }

        page.AssertClean();
    }

    [Fact]
    public async Task The_scripts_for_characters_come_with_the_first_character()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link);
        await page.UntilMovingAsync();
        Assert.Equal(0, await CountAsync());
        await page.DropAsync("boxes-1.vrm", await samples.ReadAsync("boxes-1.vrm"));
        await UntilShownAsync(page);
        Assert.Equal(1, await CountAsync());
        page.AssertClean();

        async Task<int> CountAsync() => (await page.EvaluateAsync(
            "() => performance.getEntriesByType('resource').filter(each => new URL(each.name).pathname.startsWith('/load-')).length")).GetInt32();
    }

    private const int Frames = 120;

    // The performer's limbs and the character's, within 1°. At rest, the performer's legs are 0.7° from the vertical, and the character's hang straight down.
    // After a jump in the take, both stand in the same place, although the character's strides differ.
    private const string IsLike = """
        limbs => {
          const { state, joints, character } = window.neuronMocap;
          const { performers, characters } = state();
          const [own, other] = [joints(performers[0].key), character(characters[0].id)];
          if (Math.hypot(own.Hips[0] - other.Hips[0], own.Hips[2] - other.Hips[2]) > 0.02)
            return false;

          const way = (from, to) => { const way = to.map((each, i) => each - from[i]); const length = Math.hypot(...way); return way.map(each => each / length); };
          return limbs.every(limb => {
            const [from, to] = limb.split(" ");
            const [a, b] = [way(own[from], own[to]), way(other[from], other[to])];
            return a.reduce((sum, each, i) => sum + each * b[i], 0) > Math.cos(Math.PI / 180);
          });
        }
        """;

    private static readonly string[] Limbs =
    [
        "LeftArm LeftForeArm", "LeftForeArm LeftHand", "RightArm RightForeArm", "RightForeArm RightHand",
        "LeftUpLeg LeftLeg", "LeftLeg LeftFoot", "RightUpLeg RightLeg", "RightLeg RightFoot",
    ];

    // Feet in contact stay in their place, and bend the legs for it.
    private static async Task LetFeetSlideAsync(TestPage page)
    {
        ILocator feet = page.Page.Locator("[aria-label^='Keep the feet of']");
        Assert.Equal("true", await feet.GetAttributeAsync("aria-pressed"));
        await feet.EvaluateAsync("button => button.click()");
        await page.UntilAsync("() => document.querySelector(\"[aria-label^='Keep the feet of']\").getAttribute('aria-pressed') === 'false'");
    }

    private static async Task GoAsync(TestPage page, string key, int frame)
    {
        await page.Page.Keyboard.PressAsync(key);
        await page.UntilAsync("words => document.querySelector('.readout .frame').textContent === words", $"frame {frame} of {Frames}");
    }

    private static Task UntilShownAsync(TestPage page) => page.UntilAsync(
        "() => { const { characters } = window.neuronMocap.state(); return characters.length === 1 && characters[0].isShown; }");
}
