using System.Runtime.InteropServices;

namespace NeuronMocap.Polyfills;

// Detects the operating system; the names are those of later frameworks.
internal static class SystemKinds
{
    extension(OperatingSystem)
    {
        public static bool IsLinux() => RuntimeInformation.IsOSPlatform(OSPlatform.Linux);

        public static bool IsMacOS() => RuntimeInformation.IsOSPlatform(OSPlatform.OSX);

        public static bool IsWindows() => RuntimeInformation.IsOSPlatform(OSPlatform.Windows);
    }
}
