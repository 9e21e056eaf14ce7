using System.Diagnostics;
using System.Globalization;
using NeuronMocap.Tests.RabbitMq;

namespace NeuronMocap.RabbitMq.Tests;

/// <summary>The processes of the broker end, also if a test fails.</summary>
public sealed class ChildProcessTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory().FullName;

    private string Log => Path.Combine(_folder, "log");

    [Fact]
    public async Task A_program_that_ends_by_itself_is_noticed_and_its_output_is_kept()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "There is no /bin/sh.");
        using var child = Start("echo \"$WORD $*\"; exit 7", "one two", "three");

        await Limits.UntilAsync(() => child.HasExited);

        Assert.Equal("hello one two three\n", await File.ReadAllTextAsync(Log, TestContext.Current.CancellationToken));
    }

    [Fact]
    public async Task A_program_that_wants_to_stay_is_ended()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "There is no /bin/sh.");
        int id = 0;
        using (ChildProcess child = Start("trap '' TERM INT HUP; echo $$; exec sleep 600"))
        {
            await Limits.UntilAsync(() => File.Exists(Log) && int.TryParse(File.ReadAllText(Log), CultureInfo.InvariantCulture, out id));
            Assert.False(child.HasExited);
        }

        Assert.Throws<ArgumentException>(() => Process.GetProcessById(id));
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private ChildProcess Start(string script, params string[] words) =>
        ChildProcess.Start(Log, new Dictionary<string, string>(StringComparer.Ordinal) { ["WORD"] = "hello" }, ["/bin/sh", "-c", script, "sh", .. words]);
}
