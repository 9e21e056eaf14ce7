using System.Buffers.Binary;
using System.Runtime.InteropServices;

namespace NeuronMocap.Protocol;

/// <summary>Writes packets as a server does. Allocates nothing; the caller owns the memory.</summary>
public static class PacketEncoder
{
    /// <summary>Writes a motion packet.</summary>
    /// <param name="destination">Room for 64 bytes, and 4 for every value.</param>
    /// <param name="header">The header; its count is replaced by the number of values.</param>
    /// <param name="values">The values in stream order, in cm and degrees.</param>
    /// <returns>Number of bytes written.</returns>
    /// <exception cref="ArgumentException">The destination is too short.</exception>
    /// <exception cref="InvalidOperationException">There are more values than the layout can count.</exception>
    public static int WriteMotion(Span<byte> destination, in MotionHeader header, ReadOnlySpan<float> values)
    {
        int length = RequireRoom(destination, values.Length);
        (header with { ValueCount = values.Length }).Write(destination);
        WriteValues(destination[ProtocolConstants.HeaderSize..], values);
        return length;
    }

    /// <summary>Writes a calculation packet.</summary>
    /// <param name="destination">Room for 64 bytes, and 4 for every value.</param>
    /// <param name="header">The header; its count is replaced by the number of values.</param>
    /// <param name="values">The values in stream order, in metres, metres per second and the units of the sensors.</param>
    /// <returns>Number of bytes written.</returns>
    /// <exception cref="ArgumentException">The destination is too short.</exception>
    public static int WriteCalculation(Span<byte> destination, in CalculationHeader header, ReadOnlySpan<float> values)
    {
        int length = RequireRoom(destination, values.Length);
        (header with { ValueCount = values.Length }).Write(destination);
        WriteValues(destination[ProtocolConstants.HeaderSize..], values);
        return length;
    }

    /// <summary>Writes a calculation packet of Axis Studio.</summary>
    /// <param name="destination">Room for 64 bytes and the payload.</param>
    /// <param name="header">The header; its count is replaced by the number of bytes.</param>
    /// <param name="payload">
    /// The bytes after the header, exactly as sent. Each of the 59 bones has 20 binary32 values and a 32-bit flag, little-endian.
    /// </param>
    /// <returns>Number of bytes written.</returns>
    /// <exception cref="ArgumentException">The destination is too short.</exception>
    public static int WriteStudioCalculation(Span<byte> destination, in StudioCalculationHeader header, ReadOnlySpan<byte> payload)
    {
        int length = ProtocolConstants.HeaderSize + payload.Length;
        if (destination.Length < length)
            throw new ArgumentException($"A packet of {payload.Length} bytes needs {length} bytes; the destination has {destination.Length}.", nameof(destination));

        (header with { ByteCount = payload.Length }).Write(destination);
        payload.CopyTo(destination[ProtocolConstants.HeaderSize..]);
        return length;
    }

    internal static void WriteValues(Span<byte> destination, ReadOnlySpan<float> values)
    {
        if (BitConverter.IsLittleEndian)
        {
            MemoryMarshal.AsBytes(values).CopyTo(destination);
            return;
        }

        for (int i = 0; i < values.Length; i++)
            BinaryPrimitives.WriteInt32LittleEndian(destination[(i * sizeof(float))..], BitConverter.SingleToInt32Bits(values[i]));
    }

    private static int RequireRoom(Span<byte> destination, int valueCount)
    {
        int length = ProtocolConstants.HeaderSize + (valueCount * sizeof(float));
        if (destination.Length < length)
            throw new ArgumentException($"A packet of {valueCount} values needs {length} bytes; the destination has {destination.Length}.", nameof(destination));

        return length;
    }
}
