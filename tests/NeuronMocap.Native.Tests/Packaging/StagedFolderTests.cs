using System.Runtime.InteropServices;
using System.Xml.Linq;
using NeuronMocap.Native.Tests.Infrastructure;

namespace NeuronMocap.Native.Tests.Packaging;

/// <summary>The folder created by publish.</summary>
public sealed class StagedFolderTests
{
    private static readonly string Folder = Repository.PathOf("artifacts", "native", RuntimeInformation.RuntimeIdentifier);

    public StagedFolderTests() =>
        Assert.SkipUnless(File.Exists(Path.Combine(AppContext.BaseDirectory, "native", "driver")), "The C programs are not built: a C compiler and CMake are needed, on Linux.");

    private static string Version => XDocument.Load(Repository.PathOf("Directory.Build.props")).Descendants("VersionPrefix").Single().Value;

    [Fact]
    public void Library_names_link_to_one_versioned_file()
    {
        string library = Path.Combine(Folder, "lib", $"libNeuronDataReader.so.1.{Version}");
        Assert.Null(new FileInfo(library).LinkTarget);
        Assert.Equal(Path.GetFileName(library), new FileInfo(Path.Combine(Folder, "lib", "libNeuronDataReader.so.1")).LinkTarget);
        Assert.Equal("libNeuronDataReader.so.1", new FileInfo(Path.Combine(Folder, "lib", "libNeuronDataReader.so")).LinkTarget);
    }

    [Fact]
    public void Headers_symbols_and_notices_are_there()
    {
        string[] files = ["include/NeuronDataReader.h", "include/DataType.h", "include/SocketCommand.h", "symbols/libNeuronDataReader.so.dbg", "share/doc/NeuronDataReader/LICENSE",
            "share/doc/NeuronDataReader/THIRD-PARTY-NOTICES.txt", "share/doc/NeuronDataReader/dotnet/LICENSE.TXT", "share/doc/NeuronDataReader/dotnet/THIRD-PARTY-NOTICES.TXT"];
        Assert.All(files, static file => Assert.True(new FileInfo(Path.Combine(Folder, file)).Length > 0, file));
    }

    [Theory]
    [InlineData("lib/pkgconfig/NeuronDataReader.pc", "Version: {0}")]
    [InlineData("lib/cmake/NeuronDataReader/NeuronDataReaderConfigVersion.cmake", "set(PACKAGE_VERSION \"{0}\")")]
    public void Templates_are_filled_with_the_version_and_without_paths(string file, string line)
    {
        string text = File.ReadAllText(Path.Combine(Folder, file));
        Assert.Contains(string.Format(null, line, Version), text, StringComparison.Ordinal);
        Assert.DoesNotContain('@', text);
        Assert.DoesNotContain(Repository.Root, text, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Pkg_config_follows_a_moved_folder()
    {
        SystemTool.Require("pkg-config", "pkgconf");
        string file = Path.Combine(Folder, "lib", "pkgconfig", "NeuronDataReader.pc");
        (int exitCode, string output, string errors) = await SystemTool.RunAsync("pkg-config", "--cflags", "--libs", file);
        Assert.Equal((0, string.Empty), (exitCode, errors));
        string[] words = output.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(Path.Combine(Folder, "include"), Path.GetFullPath(words.Single(static word => word.StartsWith("-I", StringComparison.Ordinal))[2..]));
        Assert.Equal(Path.Combine(Folder, "lib"), Path.GetFullPath(words.Single(static word => word.StartsWith("-L", StringComparison.Ordinal))[2..]));
        Assert.Contains("-lNeuronDataReader", words);
    }
}
