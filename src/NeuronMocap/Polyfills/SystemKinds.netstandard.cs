using System.Runtime.InteropServices;

namespace System;

// Which system this is, under the names of later frameworks.
internal static class SystemKinds
{
    extension(OperatingSystem)
    {
        public static bool IsLinux() => RuntimeInformation.IsOSPlatform(OSPlatform.Linux);

        public static bool IsWindows() => RuntimeInformation.IsOSPlatform(OSPlatform.Windows);
    }
}
