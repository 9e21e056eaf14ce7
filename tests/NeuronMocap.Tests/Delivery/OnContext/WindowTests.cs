using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

/// <summary>A window's thread, a reader and a server.</summary>
public sealed class WindowTests
{
    [Fact]
    public async Task Every_frame_and_status_arrives_in_order_on_the_windows_thread_only()
    {
        using var server = new TestServer();
        using var window = new MessageLoop();
        await using var reader = new NeuronReader(server.Options());
        List<uint?> frames = [];
        List<ConnectionState> states = [];
        int elsewhere = 0;
        FrameDelivery delivery = window.Invoke(() => reader.OpenDelivery());
        delivery.MotionReceived += frame =>
        {
            frames.Add(frame.FrameIndex);
            elsewhere += window.IsCurrent ? 0 : 1;
        };
        delivery.StatusChanged += status =>
        {
            states.Add(status.State);
            elsewhere += window.IsCurrent ? 0 : 1;
        };
        reader.Start();
        using (TestConnection connection = await server.AcceptAsync())
        {
            await connection.SendAsync(TestPackets.Motions(0, 300));
            connection.Close();
        }

        FrameDeliveryEnd end = await delivery.Completion.Soon();
        Assert.Equal(FrameDeliveryEndReason.ReaderStopped, end.Reason);
        Assert.Equal(Enumerable.Range(0, 300).Select(static index => (uint?)index), frames);
        Assert.Equal([ConnectionState.Connecting, ConnectionState.Connected, ConnectionState.Receiving, ConnectionState.Stopped], states);
        Assert.Equal((0, 1), (elsewhere, window.MostOutstanding));
        Assert.Equal((300, 0L, 0), (delivery.Delivered, delivery.Dropped, delivery.Pending));
        Assert.Empty(window.Exceptions);
    }
}
