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
