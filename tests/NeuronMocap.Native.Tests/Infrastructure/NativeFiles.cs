using System.Runtime.InteropServices;

namespace NeuronMocap.Native.Tests.Infrastructure;

/// <summary>The files to build a C program with, as staged by the build.</summary>
internal static class NativeFiles
{
    public static string Headers => Repository.PathOf("src", "NeuronMocap.Native", "include");

    public static string Sources => Repository.PathOf("tests", "native");

    public static string Library
    {
        get
        {
            string path = Repository.PathOf("artifacts", "native", RuntimeInformation.RuntimeIdentifier, "lib", "libNeuronDataReader.so");
            Assert.SkipUnless(File.Exists(path), "The library is not built: a C compiler and CMake are needed, on Linux.");
            return path;
        }
    }
}
