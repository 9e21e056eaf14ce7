using System.Diagnostics;
using System.Globalization;
using System.Net;
using System.Text.Json;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.View.Takes;

// The temporary folder has no more room. A limit for the size of files stands in for a full disk.
public sealed class FullDiskTests : IDisposable
{
    private const int Kilobytes = 512;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task A_take_and_an_upload_that_have_no_room_are_told_and_the_program_goes_on()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Other systems have no such limit for a process.");
        CancellationToken token = TestContext.Current.CancellationToken;
        Directory.CreateDirectory(_folder["temp"]);
        Files.Takes.Actor(2000).Save(_folder["long.bvh"]);
        Files.Takes.Actor(2).Save(_folder["short.bvh"]);
        using Process view = Start(_folder["long.bvh"]);
        using var end = new Disposal(() => view.Kill());
        string line = await view.StandardOutput.ReadLineAsync(token).AsTask().Soon() ?? await view.StandardError.ReadToEndAsync(token);
        using var client = new HttpClient { BaseAddress = new Uri(line[line.IndexOf("http://", StringComparison.Ordinal)..]) };

        string id = (await GetAsync(client, "api/hello")).GetProperty("take").GetString()!;
        JsonElement take = await WaitAsync(client, id);

        Assert.Equal("The temporary folder of the program has no room for the rest of the take.", Assert.Single(take.GetProperty("problems").EnumerateArray()).GetString());
        long frames = take.GetProperty("performers")[0].GetProperty("frames").GetInt64();
        Assert.InRange(frames, 1, 1999);

        // All that was read can be seen, to the end of the time line.
        byte[] last = await client.GetByteArrayAsync($"api/takes/{id}/poses?from={frames - 1}&count=9", token).Soon();
        Assert.True(CompactPose.TryDecode(last.AsSpan(sizeof(uint)), out CompactPoseHeader header, new BoneTransform[BoneHierarchy.BoneCount]));
        Assert.Equal((frames - 1) / 60.0, (header.Time - DateTimeOffset.UnixEpoch).TotalSeconds, 1e-5);
        Assert.Equal((frames - 1) / 0.06, take.GetProperty("duration").GetDouble(), 0.01);

        using HttpResponseMessage refused = await PostAsync(client, _folder["long.bvh"]);
        Assert.Equal(HttpStatusCode.InsufficientStorage, refused.StatusCode);
        Assert.Contains("disk of the program's computer may be full", await refused.Content.ReadAsStringAsync(token), StringComparison.Ordinal);
        using HttpResponseMessage accepted = await PostAsync(client, _folder["short.bvh"]);
        string other = JsonDocument.Parse(await accepted.Content.ReadAsStringAsync(token)).RootElement.GetProperty("id").GetString()!;
        Assert.Equal(2, (await WaitAsync(client, other)).GetProperty("performers")[0].GetProperty("frames").GetInt64());

        Signals.Send("TERM", view.Id);
        await view.WaitForExitAsync(token).Soon();
        Assert.Equal(0, view.ExitCode);
        Assert.DoesNotContain("at NeuronMocap", await view.StandardError.ReadToEndAsync(token), StringComparison.Ordinal);
        Assert.Empty(Directory.GetDirectories(_folder["temp"], "neuron-mocap-view-*"));
    }

    private sealed class Disposal(Action action) : IDisposable
    {
        public void Dispose() => action();
    }

    private Process Start(string file)
    {
        // Without the signal, the system refuses to write. The runtime's own files are larger with its usual protection of code.
        string script = string.Create(CultureInfo.InvariantCulture, $"trap '' XFSZ; ulimit -f {2 * Kilobytes}; exec \"$@\"");
        var start = new ProcessStartInfo("sh", ["-c", script, "sh", Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet", ToolProcess.PathOf("neuron-mocap"), "view", file, "--port", "0"])
        {
            UseShellExecute = false,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        start.Environment["TMPDIR"] = _folder["temp"];
        start.Environment["DOTNET_EnableWriteXorExecute"] = "0";
        return Process.Start(start)!;
    }

    private static async Task<HttpResponseMessage> PostAsync(HttpClient client, string file)
    {
        using var content = new ByteArrayContent(await File.ReadAllBytesAsync(file, TestContext.Current.CancellationToken));
        return await client.PostAsync("api/takes?name=take.bvh", content, TestContext.Current.CancellationToken).Soon();
    }

    private static async Task<JsonElement> GetAsync(HttpClient client, string address) =>
        JsonDocument.Parse(await client.GetStringAsync(address, TestContext.Current.CancellationToken).Soon()).RootElement;

    private static async Task<JsonElement> WaitAsync(HttpClient client, string id)
    {
        using var limit = new CancellationTokenSource(TimeSpan.FromMinutes(2));
        while (true)
        {
            JsonElement take = await GetAsync(client, $"api/takes/{id}");
            if (take.GetProperty("progress").GetDouble() == 1)
                return take;

            limit.Token.ThrowIfCancellationRequested();
            await Task.Yield();
        }
    }
}
