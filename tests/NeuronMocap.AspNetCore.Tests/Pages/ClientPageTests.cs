using System.Collections.Concurrent;
using System.ComponentModel;
using System.Diagnostics;
using System.Globalization;
using System.Text.RegularExpressions;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using NeuronMocap.AspNetCore.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.AspNetCore.Tests.Pages;

// The clients on the page docs/guide/web.md, as they stand there.
public sealed partial class ClientPageTests
{
    private static readonly string Page = File.ReadAllText(Repository.PathOf("docs", "guide", "web.md"));

    [Fact]
    public async Task The_program_in_Python_prints_frames_and_ends_with_the_stream()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        string code = CodeOf("motion.py").Replace("7100", site.Web.Port.ToString(CultureInfo.InvariantCulture), StringComparison.Ordinal).Replace("GET / ", "GET /motion ", StringComparison.Ordinal);
        Assert.InRange(code.Split('\n').Length, 1, 25);
        using Process python = Start("python3", "-c", code);
        await Limits.UntilAsync(() => site.Broadcaster.GetStatistics().Clients == 1 || python.HasExited);
        await site.Motion.SendAsync(TestPackets.Motion(7, name: "Ann"));
        string? line = await python.StandardOutput.ReadLineAsync(TestContext.Current.CancellationToken).AsTask().Soon();
        Assert.StartsWith("Ann 7 [7", line ?? await python.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken), StringComparison.Ordinal);

        await site.Reader.DisposeAsync();
        await python.WaitForExitAsync(TestContext.Current.CancellationToken).Soon();
        Assert.Equal(0, python.ExitCode);
    }

    [Fact]
    public async Task The_program_in_Python_says_why_it_is_refused()
    {
        await using MotionSite site = await MotionSite.StartAsync(new WebSocketBroadcasterOptions { Token = "word" });
        string code = CodeOf("motion.py").Replace("7100", site.Web.Port.ToString(CultureInfo.InvariantCulture), StringComparison.Ordinal).Replace("GET / ", "GET /motion ", StringComparison.Ordinal);
        using Process python = Start("python3", "-c", code);
        await python.WaitForExitAsync(TestContext.Current.CancellationToken).Soon();
        Assert.Equal(1, python.ExitCode);
        Assert.Equal("HTTP/1.1 401 Unauthorized", (await python.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken)).TrimEnd());
    }

    [Fact]
    public async Task The_page_shows_frames_in_a_browser_and_connects_again()
    {
        var seen = new ConcurrentQueue<string>();
        string page = CodeOf("motion.html");
        await using MotionSite site = await MotionSite.StartAsync(map: application =>
        {
            application.MapGet("/page", (HttpRequest request) => Results.Content(
                page.Replace("ws://127.0.0.1:7100", $"ws://{request.Host}/motion", StringComparison.Ordinal) + Probe, "text/html"));
            application.MapPost("/seen", async (HttpRequest request) => seen.Enqueue(await new StreamReader(request.Body).ReadToEndAsync(TestContext.Current.CancellationToken)));
        });
        string profile = Directory.CreateTempSubdirectory("browser").FullName;
        using Process browser = Start(
            "chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-extensions", "--disable-background-networking", "--no-first-run", $"--user-data-dir={profile}",
            "--remote-debugging-port=0", $"http://127.0.0.1:{site.Web.Port}/page");
        try
        {
            browser.BeginErrorReadLine();
            browser.BeginOutputReadLine();
            await Limits.UntilAsync(() => site.Broadcaster.GetStatistics().Clients == 1);
            await site.Motion.SendAsync(TestPackets.Motion(7, name: "Ann"));
            await Limits.UntilAsync(() => seen.Any(static text => text.StartsWith("Ann, frame 7: hips at 7,7.0009", StringComparison.Ordinal)));
            Assert.Equal(0, site.Broadcaster.GetStatistics().Refused);

            // The stream ends for good here: the page says so, and asks again.
            await site.Reader.DisposeAsync();
            await Limits.UntilAsync(() => seen.Contains("No connection. The stream has ended.") && site.Broadcaster.GetStatistics().Refused > 0);
        }
        finally
        {
            browser.Kill(entireProcessTree: true);
            await browser.WaitForExitAsync(CancellationToken.None);
            TryDelete(profile);
        }
    }

    // Tells the test what a person would see.
    private const string Probe = """
        <script>
          new MutationObserver(() => fetch("/seen", { method: "POST", body: view.textContent })).observe(view, { childList: true, characterData: true, subtree: true });
        </script>
        """;

    private static string CodeOf(string file)
    {
        Match block = Block().Matches(Page).Single(block => block.Groups["file"].Value.Equals(file, StringComparison.Ordinal));
        return block.Groups["code"].Value;
    }

    private static Process Start(string program, params string[] args)
    {
        try
        {
            return Process.Start(new ProcessStartInfo(program, args) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true })!;
        }
        catch (Win32Exception)
        {
            Assert.Skip($"There is no {program} on this computer.");
            throw;
        }
    }

    private static void TryDelete(string folder)
    {
        try
        {
            Directory.Delete(folder, recursive: true);
        }
        catch (IOException)
        {
            // A process of the browser still writes.
        }
    }

    [GeneratedRegex("<!-- file: (?<file>[^ ]+) -->\n```[a-z]+\n(?<code>.*?)^```", RegexOptions.Multiline | RegexOptions.Singleline | RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex Block();
}
