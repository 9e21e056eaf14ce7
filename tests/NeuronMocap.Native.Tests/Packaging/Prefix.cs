using NeuronMocap.Native.Tests.Infrastructure;

namespace NeuronMocap.Native.Tests.Packaging;

/// <summary>An install prefix of any system: CMake's files as filled by publish, and empty files in place of those that they refer to.</summary>
internal sealed class Prefix : IDisposable
{
    public const string Version = "1.4.2";

    public Prefix(string system, string processor, string configFile, params string[] files)
    {
        string cmake = Path.Combine(Folder, "lib", "cmake", "NeuronDataReader");
        Directory.CreateDirectory(cmake);
        File.Copy(Source(configFile), Path.Combine(cmake, "NeuronDataReaderConfig.cmake"));
        File.Copy(Source("NeuronDataReaderTargets.cmake"), Path.Combine(cmake, "NeuronDataReaderTargets.cmake"));
        File.WriteAllText(VersionFile, File.ReadAllText(Source("NeuronDataReaderConfigVersion.cmake"))
            .Replace("@VERSION@", Version, StringComparison.Ordinal)
            .Replace("@SYSTEM@", system, StringComparison.Ordinal)
            .Replace("@PROCESSOR@", processor, StringComparison.Ordinal));
        foreach (string file in files)
        {
            string path = Path.Combine(Folder, file);
            Directory.CreateDirectory(Path.GetDirectoryName(path)!);
            File.WriteAllText(path, string.Empty);
        }
    }

    /// <summary>The folder passed to CMake. In a NuGet package it is two levels below the root.</summary>
    public string Folder => Path.Combine(Root, "build", "native");

    public string Root { get; } = Directory.CreateTempSubdirectory("neuron data reader").FullName;

    public string VersionFile => Path.Combine(Folder, "lib", "cmake", "NeuronDataReader", "NeuronDataReaderConfigVersion.cmake");

    /// <summary>Runs find_package for a system, and returns the properties of the imported target.</summary>
    /// <param name="request">The text after the package's name.</param>
    /// <param name="lines">Lines of CMake before it, such as the system.</param>
    public async Task<(int ExitCode, string Output)> FindAsync(string request, params string[] lines)
    {
        string project = Path.Combine(Root, "project");
        Directory.CreateDirectory(project);
        File.WriteAllText(Path.Combine(project, "CMakeLists.txt"), $"""
            cmake_minimum_required(VERSION 3.16)
            project(request LANGUAGES NONE)
            set(CMAKE_SIZEOF_VOID_P 8)
            {string.Join('\n', lines)}
            find_package(NeuronDataReader {request} CONFIG REQUIRED)
            find_package(NeuronDataReader CONFIG REQUIRED)
            foreach(name IMPORTED_LOCATION IMPORTED_IMPLIB IMPORTED_SONAME INTERFACE_INCLUDE_DIRECTORIES)
                get_target_property(value NeuronDataReader::NeuronDataReader $<name>)
                message(STATUS "$<name>=$<value>")
            endforeach()
            """.Replace("$<name>", "${name}", StringComparison.Ordinal).Replace("$<value>", "${value}", StringComparison.Ordinal));
        (int exitCode, string output, string errors) = await SystemTool.RunAsync(
            "cmake", "-S", project, "-B", Path.Combine(project, "made"), $"-DCMAKE_PREFIX_PATH={Folder}");
        return (exitCode, output + errors);
    }

    public void Dispose() => Directory.Delete(Root, recursive: true);

    private static string Source(string name) => Repository.PathOf("src", "NeuronMocap.Native", "Packaging", name);
}
