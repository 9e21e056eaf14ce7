using System.Net.Sockets;

namespace NeuronMocap.Transport;

internal static class TcpKeepAlive
{
    // A peer whose computer lost its power or its network says nothing more, and whoever only listens would wait for ever.
    // Probes after 10 s of silence, every 2 s. Mono knows them only in the form of Windows, leaves the number of probes to the system (Windows 10, Linux 9),
    // and writes a line to the console for each of the options that .NET has; .NET in turn refuses that form everywhere but on Windows.
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
            // Not every system has this; without it a dead peer is noticed later.
        }
    }

    // Three integers of the machine: on, and the times in milliseconds.
    private static byte[] GetValues()
    {
        byte[] values = new byte[3 * sizeof(uint)];
        BitConverter.TryWriteBytes(values, 1u);
        BitConverter.TryWriteBytes(values.AsSpan(sizeof(uint)), 10_000u);
        BitConverter.TryWriteBytes(values.AsSpan(2 * sizeof(uint)), 2_000u);
        return values;
    }

    // This target has no names for them.
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
            // Not every system has all of these.
        }
    }
}
