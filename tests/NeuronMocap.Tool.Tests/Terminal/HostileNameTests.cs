using System.Globalization;
using System.Text;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Terminal;

/// <summary>Avatar names cannot control a terminal: escape sequences, C1 controls, changed directions and invisible letters have no effect.</summary>
public sealed class HostileNameTests
{
    private const string Name = "\e[2J\u009b1m\u202Eevil\u200B\u2066\a";

    [Fact]
    public async Task Plain_lines_are_clean()
    {
        using FrameServer server = Serve();
        using var output = new LeavingReader("evil");
        ToolResult result = await ToolRunner.RunAsync(output, ["watch", server.Address]);

        Assert.Equal(0, result.ExitCode);
        AssertClean(output.Text);
    }

    [Theory]
    [InlineData("diagnose", "--duration", "15")]
    [InlineData("watch", "--json", "--frames", "5")]
    [InlineData("diagnose", "--json", "--duration", "15")]
    public async Task Diagnosis_and_JSON_are_clean(string verb, params string[] args)
    {
        using FrameServer server = Serve();
        ToolResult result = await ToolRunner.RunAsync([verb, server.Address, .. args]);

        Assert.Equal(0, result.ExitCode);
        AssertClean(string.Join(' ', result.Output));
    }

    [Fact]
    public async Task An_export_message_is_clean()
    {
        using var folder = new TemporaryFolder();
        using FrameServer server = Serve();
        ToolResult result = await ToolRunner.RunAsync("watch", server.Address, "--frames", "5", "--quiet", "--export", folder["take.bvh"]);

        Assert.Equal(0, result.ExitCode);
        AssertClean(string.Join(' ', result.Error));
    }

    [Theory]
    [InlineData("watch", "\u202Eevil\u0007.invalid", "--once", "--quiet")]
    [InlineData("play", "/nowhere/\u202Eevil\e[2J", "--quiet")]
    [InlineData("watch", "--record", "/nowhere/\u202Eevil\e[2J", "--quiet")]
    [InlineData("--\u202Eevil\e[2J", "--quiet")]
    [InlineData("watch", "--\u202Eevil\e[2J", "--quiet")]
    [InlineData("\u202Eevil\e[2J")]
    public async Task Errors_are_clean(params string[] args)
    {
        ToolResult result = await ToolRunner.RunAsync(args);

        Assert.NotEqual(0, result.ExitCode);
        AssertClean(Assert.Single(result.Error));
    }

    [Fact]
    public async Task A_BVH_header_on_a_terminal_is_clean()
    {
        ToolResult result = await ToolRunner.RunOnTerminalAsync(80, "command", "demo", "header");

        Assert.Equal("HIERARCHY", result.Output[0]);
        Assert.DoesNotContain(result.Output, static line => line.Any(char.IsControl));
    }

    private static FrameServer Serve() => FrameServer.Repeating(
        FrameServer.Motion(new MotionHeader { AvatarName = new AvatarName(Name), FrameIndex = 1, HasDisplacement = true }, new float[354]));

    private static void AssertClean(string text)
    {
        Assert.Contains("evil", text, StringComparison.Ordinal);
        Assert.DoesNotContain(text, static letter => letter is not ('\t' or '\n')
            && char.GetUnicodeCategory(letter) is UnicodeCategory.Control or UnicodeCategory.Format or UnicodeCategory.Surrogate);
    }

    // Ends when it has seen enough, like `| grep -m 1`.
    private sealed class LeavingReader(string enough) : MemoryStream
    {
        private const int BrokenPipe = 32;

        public string Text => Encoding.UTF8.GetString(ToArray());

        public override void Write(byte[] buffer, int offset, int count)
        {
            if (Text.Contains(enough, StringComparison.Ordinal))
                throw new IOException("Broken pipe", BrokenPipe);

            base.Write(buffer, offset, count);
        }

        public override void Write(ReadOnlySpan<byte> buffer) => Write(buffer.ToArray(), 0, buffer.Length);
    }
}
