using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Tests.Arguments;

public sealed class SourceTests
{
    [Theory]
    [InlineData("take.nmrec")]
    [InlineData("missing.BIN")]
    [InlineData("dump.dat")]
    [InlineData("walk.bvh")]
    [InlineData("./studio")]
    [InlineData("takes/studio")]
    [InlineData("/tmp/")]
    [InlineData(@"takes\monday")]
    [InlineData("./demo")]
    public void A_file_name_is_a_file_even_if_missing(string text) => Assert.Equal(Source.OfFile(text), Parse(text));

    [Fact]
    public void An_existing_file_may_have_any_name()
    {
        string path = Path.GetFileName(Path.GetTempFileName());
        string here = Path.Combine(Directory.GetCurrentDirectory(), path[..^4]);
        File.WriteAllText(here, string.Empty);
        try
        {
            Assert.Equal(Source.OfFile(Path.GetFileName(here)), Parse(Path.GetFileName(here)));
        }
        finally
        {
            File.Delete(here);
            File.Delete(Path.Combine(Path.GetTempPath(), path));
        }
    }

    [Fact]
    public void A_word_that_differs_from_a_file_by_one_slip_is_refused_with_that_file()
    {
        string file = $"slip-{Guid.NewGuid():N}.bvh";
        File.WriteAllText(file, string.Empty);
        try
        {
            string word = file.Replace(".bvh", ".bvj", StringComparison.Ordinal);
            Assert.False(Source.TryParse(word, out _, out string? error));
            Assert.Equal($"there is no file '{word}': did you mean {file}? For a computer of that name, write tcp://{word}.", error);
            Assert.Equal(SourceKind.Tcp, Parse($"tcp://{word}").Kind);
        }
        finally
        {
            File.Delete(file);
        }
    }

    // Some domains differ from an extension in one letter.
    [Theory]
    [InlineData("studio.local")]
    [InlineData("studio.in")]
    [InlineData("studio.cat")]
    [InlineData("studio.bid")]
    [InlineData("studio.cal")]
    [InlineData("192.168.1.20")]
    [InlineData("take.bhv:7001")]
    public void A_word_that_may_be_a_computer_is_one(string text) => Assert.Equal(SourceKind.Tcp, Parse(text).Kind);

    [Theory]
    [InlineData("demo")]
    [InlineData("DEMO")]
    public void Demo_is_the_built_in_simulator(string text) => Assert.Equal(Source.Demo, Parse(text));

    private static Source Parse(string text)
    {
        Assert.True(Source.TryParse(text, out Source? source, out string? error), error);
        return source;
    }
}
