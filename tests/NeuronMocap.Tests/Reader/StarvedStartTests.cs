using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// A program may start its reader while all its pool threads are blocked. It must still receive frames.
[Collection(nameof(Alone))]
public sealed partial class StarvedStartTests
{
    private const int MostStarts = 3;

    private static readonly TimeSpan Soon = TimeSpan.FromSeconds(1);

    [Theory]
    [InlineData("127.0.0.1")]
    [InlineData("localhost")]
    public async Task A_reader_starts_and_receives_without_a_thread_of_the_pool(string host)
    {
        using var warm = new NeuronReader(host); // loads code in advance, which needs no pool but takes time
        await StarvedPool.RunAsync(() =>
        {
            using var listener = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
            listener.Bind(new IPEndPoint(IPAddress.Loopback, 0));
            listener.Listen(1);
            using var received = new CountdownEvent(3);
            using NeuronReader reader = StartUntilConnected(host, listener, received);
            using Socket connection = listener.Accept();
            connection.Send(TestPackets.Motions(0, 3));
            Assert.True(received.Wait(Limits.Unexpected), $"{reader.Status}");
        });
    }

    // If a task ends at the very moment when it is awaited, the runtime needs a pool thread. That is rare, and the next start does without it.
    private static NeuronReader StartUntilConnected(string host, Socket listener, CountdownEvent received)
    {
        for (int start = 1; ; start++)
        {
            var reader = new NeuronReader(new NeuronReaderOptions { Host = host, Port = ((IPEndPoint)listener.LocalEndPoint!).Port, Reconnect = { Enabled = false } });
            reader.MotionReceived += _ => received.Signal();
            reader.Start();
            if (listener.Poll(start < MostStarts ? Soon : Limits.Unexpected, SelectMode.SelectRead))
                return reader;

            reader.Dispose();
            Assert.True(start < MostStarts, "no reader connected");
        }
    }
}
