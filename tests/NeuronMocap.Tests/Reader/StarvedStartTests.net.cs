using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

public sealed partial class StarvedStartTests
{
    [Fact]
    public Task A_UDP_port_with_its_own_thread_needs_no_pool() => StarvedPool.RunAsync(() =>
    {
        var reader = new NeuronReader(new NeuronReaderOptions
        {
            Transport = TransportKind.Udp,
            LocalAddress = IPAddress.Loopback,
            Port = 0,
            ReceiveThread = ReceiveThread.Dedicated,
            StopTimeout = Limits.Unexpected,
        });
        using var connected = new ManualResetEventSlim();
        using var received = new CountdownEvent(3);
        reader.StatusChanged += status =>
        {
            if (status.State == ConnectionState.Connected)
                connected.Set();
        };
        reader.MotionReceived += _ => received.Signal();
        reader.Start();
        Assert.True(connected.Wait(Limits.Unexpected), $"{reader.Status}");
        using var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        for (int i = 0; i < 3; i++)
            sender.SendTo(TestPackets.Motion(i), reader.Status.LocalEndPoint!);

        Assert.True(received.Wait(Limits.Unexpected), $"{reader.Status}");
        reader.Dispose();
        Assert.True(reader.Completion.IsCompleted);
    });
}
