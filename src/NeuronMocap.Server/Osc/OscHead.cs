using System.Buffers.Binary;
using System.Numerics;
using System.Text;

namespace NeuronMocap.Server.Osc;

/// <summary>The parts of OSC messages: heads, which are prepared once, and numbers.</summary>
internal static class OscHead
{
    // An address consists of printable ASCII, except for the characters with a meaning in patterns.
    private const string Reserved = " #*,/?[]{}";

    /// <summary>Creates the head of a message whose arguments begin with one text, or are numbers only.</summary>
    public static byte[] Of(string address, string types, string? text = null) =>
        [.. Padded(address), .. Padded("," + types), .. text is null ? [] : Padded(text)];

    /// <summary>Makes one part of an address of a name.</summary>
    public static string ToPart(string name) =>
        new([.. name.Select(static letter => letter is > ' ' and <= '~' && Reserved.IndexOf(letter) < 0 ? letter : '_')]);

    public static void Write(Span<byte> place, int number) => BinaryPrimitives.WriteInt32BigEndian(place, number);

    public static void Write(Span<byte> place, float number) => BinaryPrimitives.WriteInt32BigEndian(place, BitConverter.SingleToInt32Bits(number));

    /// <summary>Writes the seven numbers of a transform.</summary>
    public static void Write(Span<byte> place, Vector3 position, Quaternion rotation)
    {
        Write(place[24..], rotation.W);
        Write(place[20..], rotation.Z);
        Write(place[16..], rotation.Y);
        Write(place[12..], rotation.X);
        Write(place[8..], position.Z);
        Write(place[4..], position.Y);
        Write(place, position.X);
    }

    /// <summary>Whether all seven numbers of a transform are finite. The rotation is a unit quaternion, or not a number.</summary>
    public static bool CanWrite(Vector3 position, Quaternion rotation)
    {
        // A product with zero is zero only for finite numbers, whose sum could be infinite.
        Vector3 zero = position * 0;
        return zero.X + zero.Y + zero.Z + (rotation.LengthSquared() * 0) == 0;
    }

    // One to four zero bytes follow, up to a multiple of 4.
    private static byte[] Padded(string text)
    {
        byte[] bytes = new byte[(Encoding.ASCII.GetByteCount(text) / 4 * 4) + 4];
        Encoding.ASCII.GetBytes(text, 0, text.Length, bytes, 0);
        return bytes;
    }
}
