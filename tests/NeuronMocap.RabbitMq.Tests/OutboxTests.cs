using NeuronMocap.RabbitMq.Publishing;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.RabbitMq.Tests;

public sealed class OutboxTests
{
    [Fact]
    public void A_full_outbox_drops_the_oldest_waiting_frame_and_its_number_stays_missing()
    {
        var outbox = new Outbox(new RabbitMqPublisherOptions { Capacity = 3 }, confirms: false);

        for (int frame = 0; frame < 5; frame++)
            outbox.Add(Frame(frame));

        Assert.Equal([3, 4, 5], Take(outbox, 3).Select(static parcel => parcel.Number));
        Assert.Equal((5, 2), (outbox.GetStatistics(0, 0).Frames, outbox.GetStatistics(0, 0).Dropped));
    }

    [Fact]
    public void What_is_not_confirmed_is_sent_again_in_order_over_the_next_connection()
    {
        var outbox = new Outbox(new RabbitMqPublisherOptions { Capacity = 10 }, confirms: true);
        for (int frame = 0; frame < 6; frame++)
            outbox.Add(Frame(frame));

        Take(outbox, 5);
        outbox.Confirm(tag: 2, multiple: true);
        outbox.Confirm(tag: 4, multiple: false);
        outbox.Confirm(tag: 99, multiple: true);
        outbox.BeginConnection();

        Assert.Equal([3, 5, 6], Take(outbox, 3).Select(static parcel => parcel.Number));
        Assert.Equal((3, 2), (outbox.GetStatistics(0, 0).Confirmed, outbox.GetStatistics(0, 0).Repeated));
        outbox.Confirm(tag: 3, multiple: true);
        Assert.Equal((6, 0), (outbox.GetStatistics(0, 0).Confirmed, outbox.GetStatistics(0, 0).Unconfirmed));
    }

    [Fact]
    public void Unconfirmed_frames_keep_their_place_and_the_newest_one_is_dropped()
    {
        var outbox = new Outbox(new RabbitMqPublisherOptions { Capacity = 2 }, confirms: true);
        outbox.Add(Frame(0));
        outbox.Add(Frame(1));
        Take(outbox, 2);

        outbox.Add(Frame(2));

        Assert.Null(outbox.Take());
        Assert.Equal((1, 2), (outbox.GetStatistics(0, 0).Dropped, outbox.GetStatistics(0, 0).Unconfirmed));
    }

    [Fact]
    public void Without_confirmations_nothing_old_is_sent_over_a_new_connection()
    {
        var outbox = new Outbox(new RabbitMqPublisherOptions { Capacity = 10 }, confirms: false);
        outbox.Add(Frame(0));

        outbox.BeginConnection();

        Assert.Null(outbox.Take());
        Assert.Equal(1, outbox.GetStatistics(0, 0).Dropped);
    }

    [Fact]
    public void A_frame_allocates_nothing_on_its_way_into_the_outbox()
    {
        var outbox = new Outbox(new RabbitMqPublisherOptions { Capacity = 16 }, confirms: false);
        MotionFrame frame = Frame(0);

        Allocations.AssertNone(() => outbox.Add(frame));
    }

    private static MotionFrame Frame(int index)
    {
        byte[] packet = TestPackets.Motion(index);
        Assert.True(MotionHeader.TryRead(packet, out MotionHeader header));
        return new MotionFrame(header, System.Runtime.InteropServices.MemoryMarshal.Cast<byte, float>(packet.AsSpan(64)));
    }

    private static List<Parcel> Take(Outbox outbox, int count) => [.. Enumerable.Range(0, count).Select(_ => outbox.Take()!)];
}
