using System.Text;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;

namespace NeuronMocap.Tool.Tests.Terminal;

public sealed class ScreenTests
{
    private readonly MemoryStream _output = new();

    [Fact]
    public void The_terminal_is_restored()
    {
        using (var screen = new Screen(_output))
            screen.Show(new Text("one"), 20, 3);

        string all = Sent();
        Assert.StartsWith("\e[?1049h", all, StringComparison.Ordinal);

        // Erased first, for terminals without an alternate screen.
        Assert.EndsWith("\e[?25h\e[2J\e[H\e[?1049l", all, StringComparison.Ordinal);
    }

    [Fact]
    public void Only_changed_lines_are_sent()
    {
        using var screen = new Screen(_output);
        screen.Show(new Text("one\ntwo"), 20, 3);
        Sent();

        screen.Show(new Text("one\nTWO"), 20, 3);

        string update = Sent();
        Assert.Contains("\e[2;1H", update, StringComparison.Ordinal);
        Assert.Contains("TWO", update, StringComparison.Ordinal);
        Assert.DoesNotContain("one", update, StringComparison.Ordinal);
    }

    [Fact]
    public void A_resize_or_resume_redraws_everything()
    {
        using var screen = new Screen(_output);
        screen.Show(new Text("one"), 20, 3);
        Sent();

        screen.Show(new Text("one"), 30, 3);
        Assert.Contains("one", Sent(), StringComparison.Ordinal);

        screen.Invalidate();
        screen.Show(new Text("one"), 30, 3);
        Assert.Contains("one", Sent(), StringComparison.Ordinal);
    }

    private string Sent()
    {
        string text = Encoding.UTF8.GetString(_output.ToArray());
        _output.SetLength(0);
        return text;
    }
}
