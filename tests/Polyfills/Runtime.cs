using System.Diagnostics;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Text;

namespace NeuronMocap;

// What Mono has without the reference assemblies of .NET Framework knowing it, and what only Linux needs.
internal enum GCKind
{
    FullBlocking,
}

internal readonly struct GCMemoryInfo(long heapSizeBytes)
{
    public long HeapSizeBytes { get; } = heapSizeBytes;

    public long FragmentedBytes => 0;
}

internal static class Runtime
{
    private static readonly Func<long> AllocatedBytes = (Func<long>)Delegate.CreateDelegate(
        typeof(Func<long>), typeof(GC).GetMethod("GetAllocatedBytesForCurrentThread", BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic)!);

    extension(GC)
    {
        public static long GetAllocatedBytesForCurrentThread() => AllocatedBytes();

        public static GCMemoryInfo GetGCMemoryInfo(GCKind kind) => new(GC.GetTotalMemory(forceFullCollection: kind == GCKind.FullBlocking));

        public static long GetTotalAllocatedBytes(bool precise)
        {
            Assert.Skip($"Mono does not count the allocations of all threads{(precise ? " precisely" : "")}.");
            return 0;
        }
    }

    extension(Timer)
    {
        public static long ActiveCount
        {
            get
            {
                Assert.Skip("Mono does not count timers.");
                return 0;
            }
        }
    }

    extension(File)
    {
        public static void CreateSymbolicLink(string path, string target)
        {
            if (symlink(target, path) != 0)
                throw new IOException($"No link '{path}' was made.");
        }

        public static FileSystemInfo? ResolveLinkTarget(string path, bool returnFinalTarget)
        {
            byte[] target = new byte[4096];
            int length = (int)readlink(path, target, target.Length);
            return length < 0 ? null : new FileInfo(Encoding.UTF8.GetString(target, 0, length));
        }
    }

    extension(Process)
    {
        public static Process Start(string program, string[] arguments) => Process.Start(program, string.Join(" ", arguments.Select(static word => $"\"{word}\"")));
    }

    [DllImport("libc")]
    private static extern int symlink(string target, string path);

    [DllImport("libc")]
    private static extern nint readlink(string path, byte[] target, nint size);
}
