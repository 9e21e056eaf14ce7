using System.Net.WebSockets;
using System.Text;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.AspNetCore.Tests.WebSockets;

public sealed class MailboxTests
{
    private readonly MessageEncoder _encoder = new();

    [Fact]
    public void A_newer_frame_replaces_the_older_one_of_its_avatar_only()
    {
        var mailbox = new Mailbox(depth: 1);
        for (int frame = 1; frame <= 3; frame++)
        {
            for (int avatar = 0; avatar < 2; avatar++)
                Put(mailbox, TestPackets.Motion(frame, avatar));
        }

        Put(mailbox, TestPackets.Calculation(9));
        Assert.Equal(4, mailbox.Dropped);
        Assert.Equal([TestPackets.Motion(3), TestPackets.Motion(3, 1), TestPackets.Calculation(9)], TakeAll(mailbox));
        Assert.Empty(TakeAll(mailbox));
    }

    [Fact]
    public void A_few_frames_wait_in_order()
    {
        var mailbox = new Mailbox(depth: 3);
        for (int frame = 1; frame <= 5; frame++)
        {
            Put(mailbox, TestPackets.Motion(frame));
            if (frame != 4)
                Put(mailbox, TestPackets.Motion(frame, avatar: 1));
        }

        Assert.Equal(3, mailbox.Dropped);
        List<byte[]> taken = TakeAll(mailbox);
        Assert.Equal([TestPackets.Motion(3), TestPackets.Motion(4), TestPackets.Motion(5)], taken.Where(static packet => MotionHeader.TryRead(packet, out MotionHeader header) && header.AvatarIndex == 0));
        Assert.Equal(6, taken.Count);
    }

    [Fact]
    public void What_waits_at_the_end_is_dropped_and_nothing_follows()
    {
        var mailbox = new Mailbox(depth: 1);
        Put(mailbox, TestPackets.Motion(1));
        mailbox.Close();
        Put(mailbox, TestPackets.Motion(2));
        Assert.Equal(1, mailbox.Dropped);
        Assert.Empty(TakeAll(mailbox));
    }

    [Fact]
    public void Invented_avatars_take_no_memory()
    {
        var mailbox = new Mailbox(depth: 1);
        Put(mailbox, TestPackets.Join(Enumerable.Range(0, 2000).Select(static avatar => TestPackets.Motion(1, avatar, count: 180))), frames: 2000);

        Assert.Equal(2000 - 1024, mailbox.Dropped);
        Assert.Equal(1024, TakeAll(mailbox).Count);
    }

    [Theory]
    [InlineData(WebSocketForm.Packet)]
    [InlineData(WebSocketForm.Pose)]
    [InlineData(WebSocketForm.Json)]
    public void A_frame_on_its_way_allocates_nothing(WebSocketForm form)
    {
        Mailbox[] clients = [new(depth: 2), new(depth: 3, maxRate: 10), new(depth: 1)];
        With(TestPackets.Motion(1), frame => Allocations.AssertNone(() =>
        {
            MotionMessage message = _encoder.Encode(frame, form)!;
            foreach (Mailbox client in clients)
                client.Put(message);

            message.Release();
            while (clients[0].TryTake(out MotionMessage? taken, out _))
                taken!.Release();
        }));
    }

    [Fact]
    public void A_message_in_use_is_not_changed()
    {
        var mailbox = new Mailbox(depth: 1);
        Put(mailbox, TestPackets.Motion(1));
        Assert.True(mailbox.TryTake(out MotionMessage? held, out _));
        byte[] before = held!.Bytes.ToArray();
        for (int frame = 2; frame < 10; frame++)
            Put(mailbox, TestPackets.Motion(frame));

        Assert.Equal(before, held.Bytes.ToArray());
        Assert.Equal(WebSocketMessageType.Binary, held.Type);
    }

    [Fact]
    public void A_line_has_no_end_of_line()
    {
        With(TestPackets.Motion(1), frame =>
        {
            MotionMessage message = _encoder.Encode(frame, WebSocketForm.Json)!;
            string line = Encoding.UTF8.GetString(message.Bytes.Span);
            Assert.StartsWith("{\"type\":\"frame\",\"avatar\":0,", line, StringComparison.Ordinal);
            Assert.EndsWith("]}", line, StringComparison.Ordinal);
            Assert.StartsWith("{\"type\":\"skeleton\",", Encoding.UTF8.GetString(message.Skeleton!), StringComparison.Ordinal);
        });
    }

    private void Put(Mailbox mailbox, byte[] packets, int frames = 1)
    {
        int taken = 0;
        With(packets, frame =>
        {
            MotionMessage message = _encoder.Encode(frame, WebSocketForm.Packet)!;
            mailbox.Put(message);
            message.Release();
            taken++;
        });
        Assert.Equal(frames, taken);
    }

    private static List<byte[]> TakeAll(Mailbox mailbox)
    {
        List<byte[]> taken = [];
        while (mailbox.TryTake(out MotionMessage? message, out _))
        {
            taken.Add(message!.Bytes.ToArray());
            message.Release();
        }

        return taken;
    }

    // Frames come from a reader only.
    private static void With(byte[] packets, Action<AvatarFrame> use)
    {
        using var reader = new NeuronReader(new MemoryStream(packets));
        using FrameQueue queue = reader.OpenQueue(2048);
        reader.Start();
        Assert.True(reader.Completion.Wait(Limits.Unexpected));
        Assert.NotEqual(0, queue.Pump(use));
    }
}
