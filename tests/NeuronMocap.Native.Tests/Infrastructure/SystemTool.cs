using System.ComponentModel;
using System.Diagnostics;

namespace NeuronMocap.Native.Tests.Infrastructure;

/// <summary>A program of the system. Tests that need a missing program are skipped.</summary>
internal static class SystemTool
{
    public static void Require(string name, string package) => Assert.SkipUnless(InstalledPrograms.Have(name), $"{name} is not installed (Debian's {package}).");

    public static async Task<(int Code, string Output, string Errors)> RunAsync(string name, params string[] arguments)
    {
        using Process process = Start(name, arguments);
        Task<string> errors = process.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);
        string output = await process.StandardOutput.ReadToEndAsync(TestContext.Current.CancellationToken).Soon();
        await process.WaitForExitAsync(TestContext.Current.CancellationToken).Soon();
        return (process.ExitCode, output, await errors);
    }

    private static Process Start(string name, string[] arguments)
    {
        try
        {
            return Process.Start(new ProcessStartInfo(name, arguments) { RedirectStandardOutput = true, RedirectStandardError = true, UseShellExecute = false })!;
        }
        catch (Win32Exception)
        {
            Assert.Skip($"{name} is not installed.");
            throw;
        }
    }
}
