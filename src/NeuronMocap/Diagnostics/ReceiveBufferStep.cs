using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// Reports how many bytes of datagrams the system keeps while the program is busy. It has no verdict, because a small buffer loses data only in a burst.
internal static class ReceiveBufferStep
{
    private const int Kilobyte = 1024;

    public static void Add(StepLog log, int? granted)
    {
        if (granted is not { } bytes)
            return;

        if (bytes >= UdpSocket.WantedBuffer / 2)
            log.Ok("buffer", $"the system keeps up to {bytes / Kilobyte} KiB of datagrams until they are read");
        else
            log.Warning("buffer", Describe(bytes, UdpSocket.IsLinux));
    }

    internal static string Describe(int bytes, bool isLinux)
    {
        string size = $"the system keeps {bytes / Kilobyte} KiB of datagrams until they are read, of the requested {UdpSocket.WantedBuffer / Kilobyte} KiB: "
            + "a burst of many avatars can lose some";
        return isLinux ? $"{size}. As root: sysctl -w net.core.rmem_max={UdpSocket.WantedBuffer}" : size;
    }
}
