using System.Runtime.InteropServices;

namespace NeuronMocap.Native.Tests.Infrastructure;

/// <summary>The library as it was staged, for programs that load it by its path or folder.</summary>
internal static class StagedLibrary
{
    public static string Folder => Repository.PathOf("artifacts", "native", "linux-" + RuntimeInformation.ProcessArchitecture.ToString().ToLowerInvariant(), "lib");

    public static string Path => System.IO.Path.Combine(Folder, "libNeuronDataReader.so");

    public static void Require() => Assert.SkipUnless(File.Exists(Path), "The library is not built: a C compiler and CMake are needed, on Linux.");
}
