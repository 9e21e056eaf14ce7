using System.Buffers.Binary;

namespace NeuronMocap.Server.Osc;

/// <summary>Takes the messages of OSC packets, whatever their bytes are.</summary>
internal interface IOscListener
{
    /// <summary>Takes a message. The spans are valid during the call.</summary>
    /// <param name="address">The address, without the zero bytes behind it.</param>
    /// <param name="types">The type tags without the comma.</param>
    /// <param name="arguments">The bytes of the arguments.</param>
    void OnMessage(ReadOnlySpan<byte> address, ReadOnlySpan<byte> types, ReadOnlySpan<byte> arguments);
}

/// <summary>Divides OSC 1.0 packets into messages. Allocates nothing and never throws because of the bytes.</summary>
internal static class OscPackets
{
    private const int BundleHead = 16;

    // Bundles in bundles are rare. A limit keeps a packet of nothing else from exhausting the stack.
    private const int MaxDepth = 8;

    private static ReadOnlySpan<byte> BundleName => "#bundle\0"u8;

    /// <summary>Reads a packet: a message, or a bundle of packets.</summary>
    /// <returns>False if a part is not OSC. The messages before it were taken.</returns>
    public static bool TryRead(ReadOnlySpan<byte> packet, IOscListener listener) => TryRead(packet, listener, MaxDepth);

    /// <summary>Reads a text and the zero bytes behind it.</summary>
    public static bool TryReadText(ref ReadOnlySpan<byte> rest, out ReadOnlySpan<byte> text)
    {
        int length = rest.IndexOf((byte)0);
        int padded = (length / 4 * 4) + 4;
        if (length < 0 || padded > rest.Length)
        {
            text = default;
            return false;
        }

        text = rest[..length];
        rest = rest[padded..];
        return true;
    }

    private static bool TryRead(ReadOnlySpan<byte> packet, IOscListener listener, int depth)
    {
        if (!packet.StartsWith(BundleName))
            return TryReadMessage(packet, listener);
        if (depth == 0 || packet.Length < BundleHead)
            return false;

        ReadOnlySpan<byte> rest = packet[BundleHead..];
        while (rest.Length >= sizeof(int))
        {
            int size = BinaryPrimitives.ReadInt32BigEndian(rest);
            rest = rest[sizeof(int)..];
            if (size <= 0 || size > rest.Length || !TryRead(rest[..size], listener, depth - 1))
                return false;

            rest = rest[size..];
        }

        return rest.IsEmpty;
    }

    private static bool TryReadMessage(ReadOnlySpan<byte> message, IOscListener listener)
    {
        ReadOnlySpan<byte> rest = message;
        if (!TryReadText(ref rest, out ReadOnlySpan<byte> address)
            || !TryReadText(ref rest, out ReadOnlySpan<byte> types)
            || address.IsEmpty || address[0] != '/'
            || types.IsEmpty || types[0] != ',')
        {
            return false;
        }

        listener.OnMessage(address, types[1..], rest);
        return true;
    }
}
