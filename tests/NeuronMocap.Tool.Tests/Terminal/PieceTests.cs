using NeuronMocap.Tool.Terminal;
using Spectre.Console;

namespace NeuronMocap.Tool.Tests.Terminal;

public sealed class PieceTests
{
    [Fact]
    public void Pieces_stay_whole_and_no_line_begins_with_a_separator() => Assert.Equal(
        ["one two · three", "four"],
        Flow(["one two", "three", "four"], width: 16),
        StringComparer.Ordinal);

    [Fact]
    public void A_wide_piece_breaks_between_words() => Assert.Equal(
        ["a", "long piece", "b"],
        Flow(["a", "long piece", "b"], width: 10),
        StringComparer.Ordinal);

    [Fact]
    public void Optional_pieces_take_no_line_of_their_own()
    {
        Assert.Equal(["one · two"], Lines(Piece.Flow([new Piece("one")], [new Piece("two"), new Piece("three")], " · ", 12), 12), StringComparer.Ordinal);
        Assert.Equal(["one"], Lines(Piece.Flow([new Piece("one")], [new Piece("a longer one")], " · ", 12), 12), StringComparer.Ordinal);
    }

    private static string[] Flow(string[] pieces, int width) => Lines(Piece.Flow(pieces.Select(static piece => new Piece(piece)), " · ", width), width);

    private static string[] Lines(IReadOnlyList<StyledLine> lines, int width)
    {
        using var text = new StringWriter();
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings { Ansi = AnsiSupport.No, ColorSystem = ColorSystemSupport.NoColors, Out = new AnsiConsoleOutput(text) });
        console.Profile.Width = width;
        console.Write(new Rows(lines));
        return [.. text.ToString().Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(static line => line.TrimEnd())];
    }
}
