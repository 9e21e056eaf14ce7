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
    public void A_name_of_a_file_is_a_file_there_or_not(string text) => Assert.Equal(Source.OfFile(text), Parse(text));

    [Fact]
    public void A_file_that_is_there_is_one_whatever_its_name()
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
    public void Demo_is_the_simulator_inside_the_program(string text) => Assert.Equal(Source.Demo, Parse(text));

    private static Source Parse(string text)
    {
        Assert.True(Source.TryParse(text, out Source? source, out string? error), error);
        return source;
    }
}
