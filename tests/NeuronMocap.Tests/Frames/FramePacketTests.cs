using System.Text;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Frames;

/// <summary>What <see cref="AvatarFrame.Packet"/> shows: the bytes as they came.</summary>
public sealed class FramePacketTests
{
    [Fact]
    public async Task A_frame_shows_the_whole_packet_that_was_received()
    {
        byte[][] packets = [TestPackets.Motion(1), TestPackets.Calculation(2), TestPackets.Motion(3)];
        await using var reader = new NeuronReader(new MemoryStream([.. packets.SelectMany(static packet => packet)]));
        using FrameQueue queue = reader.OpenQueue();
        await reader.StartAsync(TestContext.Current.CancellationToken);

        List<byte[]> seen = [];
        while (await queue.WaitAsync(TestContext.Current.CancellationToken))
            queue.Pump<AvatarFrame>(frame => seen.Add(frame.Packet.ToArray()));

        Assert.Equal(packets, seen);
    }

    [Fact]
    public async Task The_packet_of_a_line_of_text_can_be_told_apart()
    {
        string line = $"0 Char00 {string.Join(' ', Enumerable.Range(0, 354))} ||\r\n";
        await using var reader = new NeuronReader(new MemoryStream(Encoding.ASCII.GetBytes(line + line)));
        using FrameQueue queue = reader.OpenQueue();
        await reader.StartAsync(TestContext.Current.CancellationToken);

        byte[]? packet = null;
        while (await queue.WaitAsync(TestContext.Current.CancellationToken))
            queue.Pump<MotionFrame>(frame => packet = frame.Packet.ToArray());

        Assert.Equal((64 + (354 * 4), 0), (packet!.Length, packet[62] | packet[63]));
    }
}
