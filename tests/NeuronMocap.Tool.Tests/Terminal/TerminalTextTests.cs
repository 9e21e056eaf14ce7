using System.Text.Json;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Tests.Terminal;

public sealed class TerminalTextTests
{
    private static readonly JsonSerializerOptions SafeJson = new() { Encoder = TerminalText.JsonEncoder };

    [Theory]
    [InlineData("\e[2Jname", "·[2Jname")]
    [InlineData("a\r\nb\tc\0d\u007fe", "a··b·c·d·e")]
    [InlineData("a\u009b2Jb\u0085c", "a·2Jb·c")] // C1: a control sequence without ESC, and a line end
    [InlineData("name\u202egpj.exe", "name·gpj.exe")]
    [InlineData("a\u202ab\u202bc\u202cd\u202de\u2066f\u2067g\u2068h\u2069i\u200ej\u200fk\u061cl", "a·b·c·d·e·f·g·h·i·j·k·l")]
    [InlineData("a\ufeffb\u200bc\u00add\u2060e", "a·b·c·d·e")]
    [InlineData("a\u2028b\u2029c", "a·b·c")]
    [InlineData("a\ufffeb\uffffc", "a·b·c")]
    [InlineData("a\U000E0041b", "a·b")] // a tag, which terminals do not show
    public void Control_characters_become_dots(string text, string clean) =>
        Assert.Equal(clean, TerminalText.Clean(text));

    [Theory]
    [InlineData("")]
    [InlineData("Char00")]
    [InlineData("José 王小明 علي Ω")]
    [InlineData("\U0001F469\u200D\U0001F3A4 क्‍ष")]
    [InlineData("e\u0301")]
    public void Ordinary_names_are_unchanged(string name) => Assert.Same(name, TerminalText.Clean(name));

    // An attribute cannot hold half of a surrogate pair.
    [Fact]
    public void Halves_of_surrogate_pairs_become_dots() => Assert.Equal("a·b·", TerminalText.Clean("a\ud800b\udc00"));

    [Fact]
    public void JSON_escapes_control_characters()
    {
        const string Text = "\e[2J\u009b\u202e\u2028\u200b王 é";
        string json = JsonSerializer.Serialize(Text, SafeJson);

        Assert.Equal(Text, JsonSerializer.Deserialize<string>(json));
        Assert.Equal(json, TerminalText.Clean(json));
        Assert.EndsWith("王 é\"", json, StringComparison.Ordinal);
    }
}
