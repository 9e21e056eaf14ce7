using NeuronMocap.Commands;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Commands;

public sealed class DataCommandReplyTests
{
    // Every reply of known layout, between frames, with length fields as servers were observed to write them.
    private static readonly byte[][] Replies =
    [
        DataReplies.BoneSizes(("Hips", 0.102f), ("右手", 0.18f), (new string('x', 60), -1)),
        DataReplies.AvatarCount(3),
        DataReplies.BvhText("HIERARCHY\r\nROOT Hips\r\n"),
        DataReplies.Make(3, dataCount: 0, parameter: 2, value: 120, [], dataLength: 4),
        DataReplies.CombinationMode(avatar: 1, mode: 2),
        DataReplies.Make(1, dataCount: 9, parameter: 0, value: 0, [], dataLength: 192),
        DataReplies.BoneSizes(),
        DataReplies.BvhText(string.Empty),
    ];

    private static readonly byte[] Stream =
        [.. TestPackets.Motion(1, count: 9), .. Replies.SelectMany((reply, i) => (byte[])[.. reply, .. TestPackets.Motion(2 + i, count: 9)])];

    [Theory, EverySplitting]
    public void Replies_between_frames_arrive_at_every_split(Splitting splitting)
    {
        foreach (IEnumerable<ArraySegment<byte>> pieces in Splits.Of(Stream, splitting))
        {
            var log = new PacketLog();
            var assembler = new PacketAssembler(new PacketScanner(), log);
            foreach (ArraySegment<byte> piece in pieces)
                assembler.Push(piece, timestamp: 0);

            Assert.Equal(
                Replies.Select(Convert.ToHexString),
                log.Packets.Where(packet => packet.Kind == PacketKind.Command).Select(packet => Convert.ToHexString(packet.Bytes)));
            Assert.Equal((Replies.Length + 1, 0), (log.Packets.Count(packet => packet.Kind == PacketKind.Motion), log.Skipped));
        }
    }

    [Fact]
    public void Bone_sizes_have_names_and_lengths()
    {
        var reply = new DataCommandReply(Replies[0]);
        Assert.Equal([new BoneSize("Hips", 0.102f), new BoneSize("右手", 0.18f), new BoneSize(new string('x', 60), -1)], reply.BoneSizes);
        Assert.Equal(DataCommandId.BoneSize, reply.Id);
        Assert.Equal(192, reply.Payload.Length);
        Assert.Equal(Replies[0], reply.Packet.ToArray());
        Assert.Equal((null, null, null, null, null), (reply.AvatarIndex, reply.AvatarCount, reply.FrameRate, reply.CombinationMode, reply.BvhText));
    }

    [Fact]
    public void Values_in_the_parameters_are_typed()
    {
        Assert.Equal(3, new DataCommandReply(Replies[1]).AvatarCount);
        Assert.Equal("HIERARCHY\r\nROOT Hips\r\n", new DataCommandReply(Replies[2]).BvhText);
        var frequency = new DataCommandReply(Replies[3]);
        Assert.Equal((2, 120), (frequency.AvatarIndex, frequency.FrameRate));
        var mode = new DataCommandReply(Replies[4]);
        Assert.Equal((1, CombinationMode.FullBody), (mode.AvatarIndex, mode.CombinationMode));
        Assert.Null(mode.BoneSizes);
        Assert.Empty(new DataCommandReply(Replies[6]).BoneSizes!);
        Assert.Equal(string.Empty, new DataCommandReply(Replies[7]).BvhText);
    }

    [Fact]
    public void Anything_but_one_whole_packet_is_refused()
    {
        byte[] reply = Replies[0];
        Assert.Throws<ArgumentException>(() => new DataCommandReply(reply.AsSpan(0, 63)));
        Assert.Throws<ArgumentException>(() => new DataCommandReply(reply.AsSpan(0, reply.Length - 1)));
        Assert.Throws<ArgumentException>(() => new DataCommandReply([.. reply, 0]));
        Assert.Throws<ArgumentException>(() => new DataCommandReply(TestPackets.Motion(0, count: 3)));
    }
}
