using System.Diagnostics;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Reader;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

public sealed class StreamRecognizerTests
{
    private static readonly byte[] Studio = Packet(build: 1);
    private static readonly byte[] Binary = Packet(build: 0);
    private static readonly long Step = Stopwatch.Frequency / 100;

    private readonly StreamRecognizer _recognizer = new(new FrameFormat(order: null, variant: null));
    private long _now = 1;

    [Fact]
    public void The_first_of_two_active_senders_is_reported()
    {
        for (int i = 0; i < 500; i++)
        {
            Receive(Studio, source: 0);
            Receive(Binary, source: 1);
            Assert.Equal(StreamFormat.Studio, _recognizer.Describe().Format);
        }
    }

    [Fact]
    public void A_stopped_sender_makes_room_after_a_second()
    {
        Receive(Studio, source: 0);
        for (int i = 0; i < 90; i++)
            Receive(Binary, source: 1);

        Assert.Equal(StreamFormat.Studio, _recognizer.Describe().Format);
        for (int i = 0; i < 20; i++)
            Receive(Binary, source: 1);

        Assert.Equal(StreamFormat.Binary, _recognizer.Describe().Format);
        for (int i = 0; i < 500; i++)
        {
            Receive(Studio, source: 0);
            Receive(Binary, source: 1);
            Assert.Equal(StreamFormat.Binary, _recognizer.Describe().Format);
        }
    }

    private static byte[] Packet(byte build)
    {
        byte[] packet = TestPackets.Motion(1);
        packet[2] = build;
        return packet;
    }

    private void Receive(byte[] packet, int source) => _recognizer.OnFrame(new ReceivedPacket(PacketKind.Motion, packet, _now += Step, source));
}
