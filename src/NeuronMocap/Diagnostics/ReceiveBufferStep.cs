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
            log.Ok("buffer", $"the system keeps up to {bytes / Kilobyte} KiB of datagrams until they are read, of the requested {UdpSocket.WantedBuffer / Kilobyte} KiB");
        else
            log.Warning("buffer", Describe(bytes, UdpSocket.BufferSetting));
    }

    // setting: the system's setting that limits the buffer; null if there is none.
    internal static string Describe(int bytes, string? setting)
    {
        string size = $"the system keeps {bytes / Kilobyte} KiB of datagrams until they are read, of the requested {UdpSocket.WantedBuffer / Kilobyte} KiB: "
            + "a burst of many avatars can lose some";
        return setting is null ? size : $"{size}. As root: sysctl -w {setting}";
    }
}
