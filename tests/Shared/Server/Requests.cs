namespace NeuronMocap.Tests.Server;

// Requests of the vendor's b12 library, written by hand. Only the first four bytes of the parameters have a meaning.
internal static class Requests
{
    public static byte[] Create(int id, int parameter, uint dataCount = 0)
    {
        byte[] packet = new WireBytes()
            .Hex("FF AA  02 00 00 01  40 00 00 00").U32(dataCount).U32((uint)id).U32((uint)parameter).Zeros(36).Zeros(4)
            .Hex("FF BB")
            .ToArray();
        new Random(id + parameter).NextBytes(packet.AsSpan(22, 36));
        Assert.Equal(64, packet.Length);
        return packet;
    }
}
