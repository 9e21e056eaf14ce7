using NeuronMocap.Server.Osc;

namespace NeuronMocap.Server.Tests.Osc;

public sealed class OscBundleTests
{
    [Fact]
    public void A_message_has_the_bytes_of_the_specification()
    {
        List<byte[]> datagrams = [];
        var bundle = new OscBundle(512, (bytes, length) => datagrams.Add(bytes[..length]));
        OscHead.Write(bundle.Add(OscHead.Of("/oscillator/4/frequency", "f"), 4), 440f);
        OscHead.Write(bundle.Add(OscHead.Of("/foo", "si", "data"), 4), 1000);
        bundle.Flush();
        bundle.Flush();

        // The first message is an example of OSC 1.0.
        Assert.Equal(
            "2362756E646C65000000000000000001"
            + "00000020" + "2F6F7363696C6C61746F722F342F6672657175656E637900" + "2C660000" + "43DC0000"
            + "00000018" + "2F666F6F00000000" + "2C736900" + "6461746100000000" + "000003E8",
            Convert.ToHexString(Assert.Single(datagrams)));
    }

    [Theory]
    [InlineData(512)]
    [InlineData(516)]
    [InlineData(1400)]
    public void Messages_fill_datagrams_in_order_and_none_is_lost(int size)
    {
        List<byte[]> datagrams = [];
        var bundle = new OscBundle(size, (bytes, length) => datagrams.Add(bytes[..length]));
        for (int i = 0; i < 500; i++)
            OscHead.Write(bundle.Add(OscHead.Of("/" + new string('a', i % 40), "i"), 4), i);

        bundle.Flush();
        Assert.Equal(Enumerable.Range(0, 500), datagrams.SelectMany(OscMessage.ReadBundle).Select(static message => (int)message.Arguments[0]));

        // No message of the next datagram would have fit.
        for (int i = 0; i + 1 < datagrams.Count; i++)
        {
            Assert.InRange(datagrams[i].Length, 16, size);
            int next = System.Buffers.Binary.BinaryPrimitives.ReadInt32BigEndian(datagrams[i + 1].AsSpan(16));
            Assert.True(datagrams[i].Length + 4 + next > size);
        }
    }
}
