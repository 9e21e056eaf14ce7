using System.Diagnostics;
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using NeuronMocap;

// FirstFrame library|raw PORT: prints the time of the first frame, on the clock that all processes share.
int port = int.Parse(args[1], CultureInfo.InvariantCulture);
if (args[0] == "raw")
{
    using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
    socket.Connect(IPAddress.Loopback, port);
    byte[] buffer = new byte[256 * 1024];
    socket.Receive(buffer);
    Console.WriteLine(Stopwatch.GetTimestamp());
    while (socket.Receive(buffer) > 0)
        continue;
}
else
{
    long first = 0;
    using var reader = new NeuronReader(new NeuronReaderOptions { Port = port, Reconnect = { Enabled = false } });
    reader.MotionReceived += _ => first = first == 0 ? Stopwatch.GetTimestamp() : first;
    reader.Start();
    await reader.Completion;
    Console.WriteLine(first);
}
