using System.Diagnostics;

namespace NeuronMocap.UnityPackager;

/// <summary>Builds the libraries of the package with the .NET SDK that runs this program.</summary>
internal static class LibraryBuild
{
    // Each builds the libraries that it refers to.
    private static readonly string[] Projects = ["NeuronMocap.Compatibility", "NeuronMocap.Server"];

    /// <param name="repository">The root of the repository.</param>
    /// <param name="configuration">Debug or Release.</param>
    /// <exception cref="PackagerException">The SDK is missing, or a library does not compile. The message holds the errors.</exception>
    public static void Run(string repository, string configuration)
    {
        foreach (string project in Projects)
        {
            (int code, string output) = RunSdk(
                repository, "build", Path.Combine("src", project), "--configuration", configuration, "--framework", "netstandard2.1", "--verbosity", "quiet");
            if (code != 0)
                throw new PackagerException($"{project} does not build:{Environment.NewLine}{output.Trim()}");
        }
    }

    private static (int Code, string Output) RunSdk(string folder, params string[] arguments)
    {
        string sdk = Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet";
        var start = new ProcessStartInfo(sdk, arguments) { WorkingDirectory = folder, RedirectStandardOutput = true, UseShellExecute = false };
        start.Environment["DOTNET_CLI_TELEMETRY_OPTOUT"] = "1";
        start.Environment["DOTNET_NOLOGO"] = "1";
        try
        {
            using Process process = Process.Start(start) ?? throw new PackagerException($"{sdk} cannot be started.");
            string output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            return (process.ExitCode, output);
        }
        catch (System.ComponentModel.Win32Exception exception)
        {
            throw new PackagerException($"{sdk} cannot be started: {exception.Message} Install the .NET SDK 10, or build the libraries and add --no-build.");
        }
    }
}
