using System.Text;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.View;
using NeuronMocap.View.Tests.Characters;
using NeuronMocap.View.Tests.Infrastructure;

namespace NeuronMocap.View.Tests.Live;

// Everything has its place on small and on large screens.
public sealed class LayoutTests(SharedBrowser browser, CharacterSamples samples)
{
    private static readonly string Walk = Repository.PathOf("samples", "takes", "walk.bvh");

    [Fact]
    public async Task On_a_phone_the_panel_leaves_the_stage_free_and_its_rows_fit()
    {
        await using RunningView view = await RunningView.StartAsync(Walk);
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, 320, 568);
        await page.UntilMovingAsync();
        await page.DropAsync("a-long-name-of-a-character-that-somebody-exported.vrm", await samples.ReadAsync("boxes-1.vrm"));
        await page.UntilAsync("() => window.neuronMocap.state().characters[0]?.isShown");
        await page.Page.Keyboard.PressAsync("p");
        await page.UntilAsync("""
            () => {
              const place = name => document.querySelector(name).getBoundingClientRect();
              const [stage, canvas, panel] = [place(".stage"), place(".stage > canvas"), place(".panel")];
              return stage.height > 150 && Math.abs(stage.bottom - panel.top) < 1 && Math.abs(canvas.bottom - stage.bottom) < 1 && Math.abs(panel.bottom - innerHeight) < 1;
            }
            """);

        // The name and its three buttons.
        await page.UntilAsync("""
            () => {
              const row = document.querySelector(".characters li");
              const [name, ...buttons] = [row.querySelector(".name"), ...row.querySelectorAll("button")].map(each => each.getBoundingClientRect());
              return buttons.length === 3 && buttons.every((each, i) => each.top === buttons[0].top && each.top < name.bottom
                && each.left >= (i === 0 ? name.right : buttons[i - 1].right) && each.right <= innerWidth);
            }
            """);
        page.AssertClean();
    }

    [Fact]
    public async Task A_take_without_frames_says_so_and_leads_back_to_the_file()
    {
        const string LongName = "a-long-name-of-a-take-that-somebody-recorded-and-trimmed.bvh";
        using var folder = new TemporaryFolder();
        string file = await File.ReadAllTextAsync(Walk, TestContext.Current.CancellationToken);
        await File.WriteAllTextAsync(folder[LongName], file, TestContext.Current.CancellationToken);
        string empty = file[..file.IndexOf("MOTION", StringComparison.Ordinal)] + "MOTION\nFrames: 0\nFrame Time: 0.01\n";
        await using RunningView view = await RunningView.StartAsync(folder[LongName]);
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, 390, 844);
        await page.UntilMovingAsync();
        await page.DropAsync("empty.bvh", Encoding.UTF8.GetBytes(empty));
        ILocator words = page.Page.Locator(".overlay").GetByText("This take has no frames");
        await words.WaitForAsync();
        Assert.True(await page.Page.Locator(".overlay").GetByText("The file holds a skeleton but no frames.").IsVisibleAsync());

        await page.Page.Keyboard.PressAsync("p");
        ILocator back = page.Page.GetByRole(AriaRole.Button, new PageGetByRoleOptions { Name = "Back to " + LongName });
        await back.WaitForAsync();
        Assert.Equal(390, (await page.EvaluateAsync("() => document.querySelector('.panel').scrollWidth")).GetInt32());
        await back.ClickAsync();
        await page.UntilMovingAsync();
        Assert.False(await words.IsVisibleAsync());
        page.AssertClean();
    }

    [Fact]
    public async Task All_tools_are_on_the_stage_above_a_plot()
    {
        await using RunningView view = await RunningView.StartAsync(Walk);
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, 1280, 720);
        await page.UntilMovingAsync();
        Assert.True(await page.Page.Locator(".time-plot").IsVisibleAsync());
        await page.UntilAsync("""
            () => {
              const tools = [...document.querySelectorAll(".toolbar button")];
              return tools.length > 10 && tools.every(each => {
                const { left, top, width, height } = each.getBoundingClientRect();
                return each.contains(document.elementFromPoint(left + width / 2, top + height - 1));
              });
            }
            """);
        page.AssertClean();
    }

    [Theory]
    [InlineData(390, 844)]
    [InlineData(320, 568)]
    public async Task On_a_phone_the_tools_are_below_the_stage_and_the_choices_of_a_plot_have_a_margin(int width, int height)
    {
        await using RunningView view = await RunningView.StartAsync(Walk);
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, width, height);
        await page.UntilMovingAsync();
        await page.Page.Keyboard.PressAsync("v");
        await page.Page.Locator(".time-plot").WaitForAsync();
        await page.UntilAsync("""
            () => {
              const place = name => document.querySelector(name).getBoundingClientRect();
              const [stage, canvas, timeline] = [place(".stage"), place(".stage > canvas"), place(".timeline")];
              const tools = [...document.querySelectorAll(".toolbar button")].map(each => each.getBoundingClientRect());
              return stage.height > 100 && Math.abs(canvas.bottom - stage.bottom) < 1
                && tools.length > 10 && tools.every(each => each.top >= stage.bottom && each.bottom <= timeline.top && each.right <= innerWidth);
            }
            """);
        await page.UntilAsync("""
            () => {
              const choices = document.querySelector(".plot-choices");
              const end = choices.getBoundingClientRect().right - parseFloat(getComputedStyle(choices).paddingRight);
              return end < innerWidth && [...choices.querySelectorAll("select")].every(each => each.getBoundingClientRect().right <= end);
            }
            """);
        page.AssertClean();
    }
}
