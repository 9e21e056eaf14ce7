using NeuronMocap.Native.Tests.Infrastructure;

namespace NeuronMocap.Native.Tests.Packaging;

/// <summary>What CMake finds on each system with the package's own files. The libraries themselves are not needed.</summary>
public sealed class FindPackageTests
{
    private const string Header = "include/NeuronDataReader.h";

    public FindPackageTests() => SystemTool.Require("cmake", "cmake");

    [Fact]
    public async Task Linux_programs_link_to_the_major_version()
    {
        using var prefix = new Prefix("Linux", "x86_64", "NeuronDataReaderConfig.cmake", Header, "lib/libNeuronDataReader.so.1");
        (int exitCode, string output) = await prefix.FindAsync("1.4", "set(UNIX TRUE)", "set(CMAKE_SYSTEM_NAME Linux)", "set(CMAKE_SYSTEM_PROCESSOR x86_64)");
        Assert.True(exitCode == 0, output);
        Assert.Contains($"IMPORTED_LOCATION={prefix.Folder}/lib/libNeuronDataReader.so.1\n", output, StringComparison.Ordinal);
        Assert.Contains("IMPORTED_SONAME=libNeuronDataReader.so.1\n", output, StringComparison.Ordinal);
        Assert.Contains($"INTERFACE_INCLUDE_DIRECTORIES={prefix.Folder}/include\n", output, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Windows_programs_link_with_the_import_library()
    {
        using var prefix = new Prefix("Windows", "AMD64", "NeuronDataReaderConfig.cmake", Header, "bin/NeuronDataReader.dll", "lib/NeuronDataReader.lib");
        (int exitCode, string output) = await prefix.FindAsync("", "set(WIN32 TRUE)", "set(CMAKE_SYSTEM_NAME Windows)", "set(CMAKE_SYSTEM_PROCESSOR AMD64)");
        Assert.True(exitCode == 0, output);
        Assert.Contains($"IMPORTED_LOCATION={prefix.Folder}/bin/NeuronDataReader.dll\n", output, StringComparison.Ordinal);
        Assert.Contains($"IMPORTED_IMPLIB={prefix.Folder}/lib/NeuronDataReader.lib\n", output, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_macOS_name_is_relative_to_the_search_path()
    {
        using var prefix = new Prefix("Darwin", "arm64", "NeuronDataReaderConfig.cmake", Header, "lib/libNeuronDataReader.1.dylib");
        (int exitCode, string output) = await prefix.FindAsync("", "set(APPLE TRUE)", "set(CMAKE_SYSTEM_NAME Darwin)", "set(CMAKE_SYSTEM_PROCESSOR arm64)");
        Assert.True(exitCode == 0, output);
        Assert.Contains("IMPORTED_SONAME=@rpath/libNeuronDataReader.1.dylib\n", output, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("set(WIN32 TRUE)", "Windows", "AMD64", "win-x64", "NeuronDataReader.dll")]
    [InlineData("set(APPLE TRUE)", "Darwin", "arm64", "osx-arm64", "libNeuronDataReader.dylib")]
    [InlineData("set(UNIX TRUE)", "Linux", "aarch64", "linux-arm64", "libNeuronDataReader.so")]
    public async Task The_NuGet_package_selects_the_runtime(string kind, string system, string processor, string runtime, string file)
    {
        using var prefix = new Prefix("Linux|Windows|Darwin", "x86_64|AMD64|aarch64|arm64", "NuGet/NeuronDataReaderConfig.cmake",
            Header, $"../../runtimes/{runtime}/native/{file}", $"lib/{runtime}/NeuronDataReader.lib");
        (int exitCode, string output) = await prefix.FindAsync("", kind, $"set(CMAKE_SYSTEM_NAME {system})", $"set(CMAKE_SYSTEM_PROCESSOR {processor})");
        Assert.True(exitCode == 0, output);
        string location = output.Split('\n').Single(static line => line.Contains("IMPORTED_LOCATION=", StringComparison.Ordinal)).Split('=')[1];
        string? target = new FileInfo(location).ResolveLinkTarget(returnFinalTarget: true)?.FullName;
        Assert.Equal($"{prefix.Root}/runtimes/{runtime}/native/{file}", target ?? location);
    }

    [Fact]
    public async Task A_package_without_the_runtime_names_the_missing_file()
    {
        using var prefix = new Prefix("Linux|Windows", "x86_64|AMD64", "NuGet/NeuronDataReaderConfig.cmake", Header, "../../runtimes/linux-x64/native/libNeuronDataReader.so");
        (int exitCode, string output) = await prefix.FindAsync("", "set(WIN32 TRUE)", "set(CMAKE_SYSTEM_NAME Windows)", "set(CMAKE_SYSTEM_PROCESSOR AMD64)");
        Assert.NotEqual(0, exitCode);
        Assert.Contains("is missing", string.Join(' ', output.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries)), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("1.4.2", true)]
    [InlineData("1.4.2 EXACT", true)]
    [InlineData("0.1", true)]
    [InlineData("1.4.3", false)]
    [InlineData("1.4.1 EXACT", false)]
    [InlineData("2", false)]
    [InlineData("0.5...1.9", true)]
    [InlineData("0.5...<1.4.2", false)]
    [InlineData("1.5...2", false)]
    public async Task A_newer_version_satisfies_every_older_request(string request, bool satisfied)
    {
        using var prefix = new Prefix("Linux", "x86_64", "NeuronDataReaderConfig.cmake", Header, "lib/libNeuronDataReader.so.1");
        (int exitCode, string output) = await prefix.FindAsync(request, "set(UNIX TRUE)", "set(CMAKE_SYSTEM_NAME Linux)", "set(CMAKE_SYSTEM_PROCESSOR x86_64)");
        Assert.True(exitCode == 0 == satisfied, output);
    }

    [Theory]
    [InlineData("set(CMAKE_SYSTEM_NAME Windows)")]
    [InlineData("set(CMAKE_SYSTEM_PROCESSOR aarch64)")]
    [InlineData("set(CMAKE_SIZEOF_VOID_P 4)")]
    public async Task A_library_for_another_machine_is_skipped(string machine)
    {
        using var prefix = new Prefix("Linux", "x86_64", "NeuronDataReaderConfig.cmake", Header, "lib/libNeuronDataReader.so.1");
        (int exitCode, string output) = await prefix.FindAsync("1", "set(CMAKE_SYSTEM_NAME Linux)", "set(CMAKE_SYSTEM_PROCESSOR x86_64)", machine);
        Assert.NotEqual(0, exitCode);
        Assert.Contains("version: 1.4.2 (", output, StringComparison.Ordinal);
    }
}
