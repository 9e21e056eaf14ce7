using System.ComponentModel;
using System.Runtime.InteropServices;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>Sends signals to processes. The program kill would do so too, but not every system has it.</summary>
internal static class Signals
{
    public static void Send(string signal, int process)
    {
        int number = signal switch
        {
            "INT" => 2,
            "TERM" => 15,
            _ => throw new ArgumentOutOfRangeException(nameof(signal), signal, null),
        };
        if (Kill(process, number) != 0)
            throw new Win32Exception(Marshal.GetLastWin32Error());
    }

    [DllImport("libc", EntryPoint = "kill", SetLastError = true)]
    private static extern int Kill(int process, int signal);
}
