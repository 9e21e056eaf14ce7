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
            Process browser = Process.Start(CommandFor(link)) ?? throw new Win32Exception();
            _ = WatchAsync(browser, link, streams);
        }
        catch (Exception exception) when (exception is Win32Exception or InvalidOperationException or PlatformNotSupportedException)
        {
            streams.Complain(Describe(link));
        }
    }

    private static ProcessStartInfo CommandFor(string link)
    {
        if (OperatingSystem.IsWindows())
            return new ProcessStartInfo(link) { UseShellExecute = true };

        // The words of the browser would mix with those of this program.
        return new ProcessStartInfo(OperatingSystem.IsMacOS() ? "open" : "xdg-open", [link])
        {
            UseShellExecute = false,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
    }

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
