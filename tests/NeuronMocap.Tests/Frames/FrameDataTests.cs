using NeuronMocap.Frames;

namespace NeuronMocap.Tests.Frames;

public sealed class FrameDataTests
{
    private static readonly byte[] Large = GoldenPackets.NewMotion([1, 2, 3, 4]);
    private static readonly byte[] Small = GoldenPackets.NewMotion([5]);

    [Fact]
    public void A_copy_after_a_borrow_leaves_the_borrowed_memory_alone()
    {
        byte[] lent = [0, 0, 0, .. Large, 0];
        var data = default(FrameData);
        data.Borrow(lent, 3, Large.Length);
        data.Copy(Small);

        Assert.Equal(Small, data.Packet.ToArray());
        Assert.Equal(Small[..64], data.Header.ToArray());
        Assert.Equal([5f], data.Values.ToArray());
        Assert.Equal([0, 0, 0, .. Large, 0], lent);
    }

    [Fact]
    public void Consecutive_copies_may_have_any_size()
    {
        var data = default(FrameData);
        foreach (byte[] packet in (byte[][])[Small, Large, Small, GoldenPackets.NewMotion([]), Large])
        {
            data.Copy(packet);
            Assert.Equal(packet, data.Packet.ToArray());
            Assert.Equal((packet.Length - 64) / 4, data.Values.Length);
        }
    }

    [Fact]
    public void A_copy_that_fits_allocates_nothing()
    {
        var data = default(FrameData);
        data.Copy(Large);
        Allocations.AssertNone(() =>
        {
            data.Copy(Small);
            data.Copy(Large);
        });
    }

    // What a big-endian machine does with a packet before it reads the values.
    [Fact]
    public void Swapping_reverses_only_the_values()
    {
        var data = default(FrameData);
        data.Copy(Large);
        data.SwapValues();

        Assert.Equal(Large[..64], data.Header.ToArray());
        for (int i = 64; i < Large.Length; i += 4)
            Assert.Equal([Large[i + 3], Large[i + 2], Large[i + 1], Large[i]], data.Packet.Slice(i, 4).ToArray());
    }
}
