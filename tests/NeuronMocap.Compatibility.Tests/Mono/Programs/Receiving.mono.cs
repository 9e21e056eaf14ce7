using System;
using System.Net;
using System.Net.Sockets;
using NeuronMocap;

// Compiled and run by Mono. Receives over TCP, over UDP, and from a server that closes repeatedly, and prints what arrived.
public static class Program
{
    // Arguments: the ports of a TCP broadcast, of a server that is told the UDP port, and of the server that closes; then the number of frames to
    // wait for from each.
    public static void Main(string[] arguments)
    {
        int frames = int.Parse(arguments[3]);
        using (var reader = new NeuronReader(OptionsFor(arguments[0], reconnects: false)))
            Receive("tcp", reader, frames, delegate { });

        var udp = new NeuronReaderOptions { Transport = TransportKind.Udp, LocalAddress = IPAddress.Loopback, Port = 0 };
        using (var reader = new NeuronReader(udp))
        using (var asking = new TcpClient("127.0.0.1", int.Parse(arguments[1])))
        {
            Receive("udp", reader, frames, delegate
            {
                reader.StartAsync().Wait();
                asking.GetStream().Write(BitConverter.GetBytes(((IPEndPoint)reader.Status.LocalEndPoint).Port), 0, 4);
            });
        }

        using (var reader = new NeuronReader(OptionsFor(arguments[2], reconnects: true)))
        {
            Receive("again", reader, frames, delegate { });
            Console.WriteLine(reader.GetStatistics().Reconnects);
        }
    }

    private static NeuronReaderOptions OptionsFor(string port, bool reconnects)
    {
        var options = new NeuronReaderOptions { Port = int.Parse(port) };
        options.Reconnect.Enabled = reconnects;
        options.Reconnect.InitialDelay = TimeSpan.FromMilliseconds(1);
        options.Reconnect.MaxDelay = TimeSpan.FromMilliseconds(5);
        return options;
    }

    private static void Receive(string how, NeuronReader reader, int frames, Action started)
    {
        uint sum = 0;
        int count = 0;
        using (FrameQueue queue = reader.OpenQueue(4096))
        {
            reader.Start();
            started();
            DateTime end = DateTime.UtcNow.AddSeconds(30);
            while (count < frames && DateTime.UtcNow < end)
            {
                queue.Pump<MotionFrame>(frame =>
                {
                    count++;
                    foreach (float value in frame.Values.ToArray())
                        sum = sum * 31 + (uint)BitConverter.ToInt32(BitConverter.GetBytes(value), 0);
                });
                System.Threading.Thread.Sleep(1);
            }
        }

        ReaderStatistics statistics = reader.GetStatistics();
        Console.WriteLine(how + " " + count + " " + sum + " " + statistics.Lost + " " + statistics.BytesSkipped);
    }
}
