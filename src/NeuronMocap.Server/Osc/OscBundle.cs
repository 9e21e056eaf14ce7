using System.Buffers.Binary;

namespace NeuronMocap.Server.Osc;

/// <summary>Collects OSC 1.0 messages into bundles that fit a datagram each. Allocates nothing after the constructor.</summary>
/// <param name="maxSize">Size of the largest bundle. A message with the heads of a bundle must fit.</param>
/// <param name="send">Sends a bundle: the first bytes of an array, and their number.</param>
internal sealed class OscBundle(int maxSize, Action<byte[], int> send)
{
    // "#bundle", and a time tag that means at once.
    private static readonly byte[] Head = [.. "#bundle\0"u8, 0, 0, 0, 0, 0, 0, 0, 1];

    private readonly byte[] _bytes = Create(maxSize);
    private int _length = Head.Length;

    /// <summary>Adds a message. If it does not fit, the messages before it are sent first.</summary>
    /// <param name="head">Address, type tags and the first arguments, from <see cref="OscHead"/>.</param>
    /// <param name="size">Number of bytes of the remaining arguments, a multiple of 4.</param>
    /// <returns>The place of the remaining arguments, to be written before the next call.</returns>
    public Span<byte> Add(byte[] head, int size)
    {
        int length = head.Length + size;
        if (_length + sizeof(int) + length > _bytes.Length)
            Flush();

        BinaryPrimitives.WriteInt32BigEndian(_bytes.AsSpan(_length), length);
        head.CopyTo(_bytes, _length + sizeof(int));
        _length += sizeof(int) + length;
        return _bytes.AsSpan(_length - size, size);
    }

    /// <summary>Sends what has not been sent.</summary>
    public void Flush()
    {
        if (_length > Head.Length)
            send(_bytes, _length);

        _length = Head.Length;
    }

    private static byte[] Create(int size)
    {
        byte[] bytes = new byte[size];
        Head.CopyTo(bytes, 0);
        return bytes;
    }
}
