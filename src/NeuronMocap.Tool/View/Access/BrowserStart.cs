using System.ComponentModel;
using System.Diagnostics;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.View.Access;

/// <summary>Starts the browser of the user.</summary>
internal static class BrowserStart
{
    /// <summary>Starts the browser with a link. If it does not start, one line on standard error says so.</summary>
    public static void Open(string link, StandardStreams streams)
    {
        try
        {
            _ = WatchAsync(Start(link), link, streams);
        }
        catch (Exception exception) when (exception is Win32Exception or InvalidOperationException or PlatformNotSupportedException)
        {
            streams.Complain(Describe(link));
        }
    }

    private static Process Start(string link)
    {
        if (OperatingSystem.IsWindows())
            return Process.Start(new ProcessStartInfo(link) { UseShellExecute = true }) ?? throw new Win32Exception();
        if (OperatingSystem.IsMacOS())
            return Start("open", link);

        // Ctrl+C in the terminal reaches all programs of the session, and must not end a browser that xdg-open starts.
        try
        {
            return Start("setsid", "xdg-open", link);
        }
        catch (Win32Exception)
        {
            return Start("xdg-open", link);
        }
    }

    // The words of the browser would mix with those of this program.
    private static Process Start(string program, params string[] arguments) =>
        Process.Start(new ProcessStartInfo(program, arguments) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true }) ?? throw new Win32Exception();

    // xdg-open starts and then finds no browser.
    private static async Task WatchAsync(Process browser, string link, StandardStreams streams)
    {
        using (browser)
        {
            if (browser.StartInfo.UseShellExecute)
                return;

            await Task.WhenAll(browser.StandardOutput.ReadToEndAsync(), browser.StandardError.ReadToEndAsync(), browser.WaitForExitAsync());
            if (browser.ExitCode != 0)
                await streams.ComplainAsync(Describe(link));
        }
    }

    private static string Describe(string link) => $"--open: no browser could be started. Open {link} yourself.";
}
