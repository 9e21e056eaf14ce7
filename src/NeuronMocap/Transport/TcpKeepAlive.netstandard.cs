using System.Net.Sockets;

namespace NeuronMocap.Transport;

internal static class TcpKeepAlive
{
    // A peer that loses its power or its network sends nothing more. A computer that only listens would wait forever. Sends probes after 10 s of silence,
    // every 2 s. Mono supports these options only in the form of Windows, which .NET supports only on Windows. With this form, the system chooses the
    // number of probes (Windows 10, Linux 9). For each option in the form of .NET, Mono writes a line to the console.
    public static void Enable(Socket socket)
    {
        try
        {
            socket.SetSocketOption(SocketOptionLevel.Socket, SocketOptionName.KeepAlive, optionValue: true);
            socket.IOControl(IOControlCode.KeepAliveValues, GetValues(), optionOutValue: null);
        }
        catch (PlatformNotSupportedException)
        {
            SetOptions(socket);
        }
        catch (SocketException)
        {
            // Not every system has this option; without it a dead peer is noticed later.
        }
    }

    // Three integers in the byte order of this computer: on, and the times in milliseconds.
    private static byte[] GetValues()
    {
        byte[] values = new byte[3 * sizeof(uint)];
        BitConverter.TryWriteBytes(values, 1u);
        BitConverter.TryWriteBytes(values.AsSpan(sizeof(uint)), 10_000u);
        BitConverter.TryWriteBytes(values.AsSpan(2 * sizeof(uint)), 2_000u);
        return values;
    }

    // This target framework has no names for these options.
    private static void SetOptions(Socket socket)
    {
        const SocketOptionName Time = (SocketOptionName)3;
        const SocketOptionName RetryCount = (SocketOptionName)16;
        const SocketOptionName Interval = (SocketOptionName)17;
        try
        {
            socket.SetSocketOption(SocketOptionLevel.Tcp, Time, 10);
            socket.SetSocketOption(SocketOptionLevel.Tcp, Interval, 2);
            socket.SetSocketOption(SocketOptionLevel.Tcp, RetryCount, 5);
        }
        catch (SocketException)
        {
            // Not every system has all of these options.
        }
    }
}
