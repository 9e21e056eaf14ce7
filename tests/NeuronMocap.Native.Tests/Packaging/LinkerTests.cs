using NeuronMocap.Native.Tests.Infrastructure;

namespace NeuronMocap.Native.Tests.Packaging;

/// <summary>The messages of a build that cannot create the library.</summary>
public sealed class LinkerTests
{
    [Theory]
    [InlineData("-p:CppCompilerAndLinker=no-such-compiler", "needs no-such-compiler and objcopy", "apt install gcc libc6-dev")]
    [InlineData("-p:RuntimeIdentifier=win-x64", "win-x64 must be published on Windows", "Desktop development with C++")]
    [InlineData("-p:RuntimeIdentifier=osx-arm64", "osx-arm64 must be published on macOS", "xcode-select --install")]
    public async Task The_error_names_what_to_install(string property, string reason, string remedy)
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "What Linux says.");
        (int exitCode, string output, string errors) = await SystemTool.RunAsync(
            "dotnet", "msbuild", Repository.PathOf("src", "NeuronMocap.Native"), "-t:RequireLinker", "-v:q", "-nodeReuse:false", property);
        Assert.NotEqual(0, exitCode);
        Assert.Contains(reason, output + errors, StringComparison.Ordinal);
        Assert.Contains(remedy, output + errors, StringComparison.Ordinal);
    }
}
