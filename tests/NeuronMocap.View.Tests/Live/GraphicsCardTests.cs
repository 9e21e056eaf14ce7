using NeuronMocap.Tool.Tests.View;
using NeuronMocap.View.Tests.Infrastructure;

namespace NeuronMocap.View.Tests.Live;

// What the page draws on a graphics card: gloss, shadows, smooth edges and a skinned figure. The processor draws it here, under another name.
public sealed class GraphicsCardTests(SharedBrowser browser)
{
    private const string OtherName = """
        (() => {
          const get = WebGL2RenderingContext.prototype.getParameter;
          WebGL2RenderingContext.prototype.getParameter = function (name) {
            return name === this.RENDERER ? "Test card" : get.call(this, name);
          };
        })();
        """;

    [Theory]
    [InlineData(ColorScheme.Dark)]
    [InlineData(ColorScheme.Light)]
    public async Task The_figure_and_the_sticks_are_drawn_with_gloss_and_shadows(ColorScheme theme)
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        await using TestPage page = await TestPage.OpenAsync(browser, view.Link, 160, 120, theme, draws: true, script: OtherName);
        await page.UntilMovingAsync();
        Assert.False((await page.EvaluateAsync("() => window.neuronMocap.stats().isSoftware")).GetBoolean());
        await page.UntilDrawnAsync(2);
        await page.Page.Keyboard.PressAsync("b");
        await page.UntilDrawnAsync(2);
        Assert.True((await page.EvaluateAsync("() => document.querySelector('canvas').getContext('webgl2').getContextAttributes().antialias")).GetBoolean());
        page.AssertClean();
    }
}
