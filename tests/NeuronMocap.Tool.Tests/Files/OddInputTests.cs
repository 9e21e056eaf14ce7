using System.Diagnostics;
using System.Net.Sockets;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Files;

/// <summary>Names on a command line that are not regular files.</summary>
public sealed class OddInputTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public static TheoryData<string, string> Inputs
    {
        get
        {
            var data = new TheoryData<string, string>();
            foreach (string tool in (string[])["info", "convert", "plot", "play"])
            {
                foreach (string kind in (string[])["pipe", "socket", "folder", "/dev/zero", "/dev/urandom", "/dev/full", "/dev/null", "/proc/self/status", "/proc/kmsg"])
                    data.Add(tool, kind);
            }

            return data;
        }
    }

    [Theory, MemberData(nameof(Inputs))]
    public async Task A_special_file_is_refused_at_once(string tool, string kind)
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Windows has no such files.");
        using Socket? socket = kind == "socket" ? Listen(_folder["socket"]) : null;
        string input = kind switch
        {
            "pipe" => MakePipe(_folder["pipe"]),
            "socket" => _folder["socket"],
            "folder" => Directory.CreateDirectory(_folder["folder"]).FullName,
            _ => kind,
        };
        Assert.SkipUnless(Path.Exists(input), $"There is no {input} here.");

        string[] output = tool switch { "convert" => [_folder["out.nmrec"]], "plot" => [_folder["out.svg"]], _ => [] };
        ToolResult result = await ToolRunner.RunAsync([tool, input, .. output]);
        Assert.Equal(1, result.ExitCode);
        Assert.Empty(result.Output);
        Assert.Matches("regular files|is empty", Assert.Single(result.Error));
        Assert.Contains(input, result.Error[0], StringComparison.Ordinal);
        Assert.DoesNotContain(_folder.Names, static name => name.StartsWith("out", StringComparison.Ordinal));
    }

    // Sentences contain the words of BVH files, too.
    [Theory]
    [InlineData("info")]
    [InlineData("convert")]
    [InlineData("plot")]
    [InlineData("play")]
    public async Task A_text_about_motion_is_no_file_of_motion(string tool)
    {
        _folder.Write("readme.md", "# A hierarchy of joints\n\nMotion from suits\nover three channels.\n");
        string[] output = tool switch { "convert" => [_folder["out.nmrec"]], "plot" => [_folder["out.svg"]], _ => [] };
        ToolResult result = await ToolRunner.RunAsync([tool, _folder["readme.md"], .. output]);
        Assert.Equal(1, result.ExitCode);
        string line = Assert.Single(result.Error);
        Assert.Contains("readme.md' is neither a recording nor a dump of a stream", line, StringComparison.Ordinal);
        Assert.DoesNotContain("HIERARCHY", line, StringComparison.Ordinal);
        Assert.DoesNotContain("turns it into one", line, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("HIERARCHY\nROOT Hips {")]
    [InlineData("\r\n  hierarchy  \rROOT Hips")]
    [InlineData("HIERARCHY ROOT Hips { OFFSET 0 0 0 CHANNELS 3 Xrotation")]
    [InlineData("ROOT Hips\n{\n\tCHANNELS 6 Xposition")]
    [InlineData("MOTION\nFrames: 2\n")]
    public void A_damaged_BVH_file_is_still_one(string text)
    {
        _folder.Write("a.bvh", text);
        Assert.Equal(FileKind.Bvh, FileKinds.Recognize(_folder["a.bvh"]));
    }

    [Theory]
    [InlineData("convert", "b.bvh")]
    [InlineData("plot", "b.svg")]
    public async Task Only_a_regular_file_is_replaced(string tool, string name)
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Windows has no such files.");
        Takes.Actor(2).Save(_folder["a.bvh"]);
        MakePipe(_folder[name]);
        ToolResult result = await ToolRunner.RunAsync(tool, _folder["a.bvh"], _folder[name], "--overwrite");
        Assert.Equal(1, result.ExitCode);
        Assert.Contains("a pipe (FIFO)", Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.Equal(["a.bvh", name], _folder.Names);
    }

    [Theory]
    [InlineData("--bvh")]
    [InlineData("--calc")]
    [InlineData("--play")]
    public async Task The_simulator_reads_no_pipe(string option)
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Windows has no such files.");
        using var simulator = new ToolProcess("neuron-mocap simulate", option, MakePipe(_folder["pipe"]), "--port", "0");
        Assert.Equal(1, await simulator.WaitForExitAsync());
        Assert.Contains("a pipe", await simulator.ReadErrorAsync(), StringComparison.Ordinal);
    }

    // The first look at bytes without times reads all of them: here 64 GB of a sparse file that is not on the disk.
    [Theory]
    [InlineData(130, "info")]
    [InlineData(130, "convert", "out.nmrec")]
    [InlineData(130, "plot", "out.svg")]
    [InlineData(0, "play")]
    public async Task A_signal_ends_uninterruptible_work(int exitCode, string tool, string? output = null)
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Other systems may write all of the file.");
        using (FileStream file = File.Create(_folder["sparse.bin"]))
            file.SetLength(64L << 30);

        using var monitor = new ToolProcess("neuron-mocap", [tool, _folder["sparse.bin"], .. output is null ? (string[])[] : [_folder[output]]]);
        await WaitUntilReadAsync(monitor.Id, _folder["sparse.bin"]);
        Signals.Send("TERM", monitor.Id);
        Assert.Equal(exitCode, await monitor.WaitForExitAsync());
        Assert.Equal(["sparse.bin"], _folder.Names);
    }

    [Fact]
    public async Task A_signal_ends_a_starting_simulator()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Other systems may write all of the file.");
        using (FileStream file = File.Create(_folder["sparse.bin"]))
            file.SetLength(64L << 30);

        using var simulator = new ToolProcess("neuron-mocap simulate", "--port", "0", "--play", _folder["sparse.bin"]);
        await WaitUntilReadAsync(simulator.Id, _folder["sparse.bin"]);
        Signals.Send("TERM", simulator.Id);
        Assert.Equal(130, await simulator.WaitForExitAsync());
    }

    [Fact]
    public async Task The_simulator_sanitizes_the_text_of_a_file()
    {
        string path = _folder.Write("odd.bvh", Takes.TwoJoints.Replace("0.04", "\u009b31m\u202e", StringComparison.Ordinal));
        using var simulator = new ToolProcess("neuron-mocap simulate", "--bvh", path, "--port", "0");
        Assert.Equal(1, await simulator.WaitForExitAsync());
        string error = (await simulator.ReadErrorAsync()).TrimEnd();
        Assert.Equal(error, TerminalText.Clean(error));
    }

    [Theory]
    [InlineData("info")]
    [InlineData("play")]
    public async Task An_empty_name_is_reported(string tool)
    {
        ToolResult result = await ToolRunner.RunAsync(tool, " ");
        Assert.Equal(1, result.ExitCode);
        Assert.Contains("empty", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    public void Dispose() => _folder.Dispose();

    // The program handles signals long before it opens a file.
    private static async Task WaitUntilReadAsync(int process, string path)
    {
        while (!Directory.GetFiles($"/proc/{process}/fd").Any(file => IsLinkTo(file, path)))
            await Task.Delay(TimeSpan.FromMilliseconds(20), TestContext.Current.CancellationToken);
    }

    // The process may close a file between the listing and the check.
    private static bool IsLinkTo(string file, string path)
    {
        try
        {
            return string.Equals(File.ResolveLinkTarget(file, returnFinalTarget: false)?.FullName, path, StringComparison.Ordinal);
        }
        catch (IOException)
        {
            return false;
        }
    }

    private static Socket Listen(string path)
    {
        var socket = new Socket(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified);
        socket.Bind(new UnixDomainSocketEndPoint(path));
        socket.Listen();
        return socket;
    }

    private static string MakePipe(string path)
    {
        using Process process = Process.Start(new ProcessStartInfo("mkfifo") { ArgumentList = { path }, UseShellExecute = false })!;
        process.WaitForExit();
        return path;
    }
}
