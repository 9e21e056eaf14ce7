using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Frames;

// The wire image of one packet behind a frame: borrowed from the receive path where the processor can read floats in place, else copied.
internal struct FrameData
{
    // 32-bit ARM faults on a misaligned float; a stream that lost or gained bytes puts packets at any address.
    private static readonly bool ReadsMisaligned =
        RuntimeInformation.ProcessArchitecture is Architecture.X64 or Architecture.X86 or Architecture.Arm64;

    private byte[] _bytes;
    private int _offset;
    private int _length;
    private byte[]? _own;

    public readonly ReadOnlySpan<byte> Header => _bytes.AsSpan(_offset, ProtocolConstants.HeaderSize);

    public readonly int ValueCount => (_length - ProtocolConstants.HeaderSize) / sizeof(float);

    public readonly ReadOnlySpan<float> Values => MemoryMarshal.Cast<byte, float>(
        _bytes.AsSpan(_offset + ProtocolConstants.HeaderSize, _length - ProtocolConstants.HeaderSize));

    public readonly ReadOnlySpan<byte> Packet => _bytes.AsSpan(_offset, _length);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Borrow(byte[] bytes, int offset, int length)
    {
        if (!BitConverter.IsLittleEndian || (!ReadsMisaligned && offset % sizeof(float) != 0))
        {
            Copy(bytes.AsSpan(offset, length));
            if (!BitConverter.IsLittleEndian)
                SwapValues();
            return;
        }

        _bytes = bytes;
        _offset = offset;
        _length = length;
    }

    // Takes a packet whose values already have this machine's byte order.
    public void Copy(ReadOnlySpan<byte> packet)
    {
        if (_own is null || _own.Length < packet.Length)
            _own = new byte[packet.Length];

        packet.CopyTo(_own);
        _bytes = _own;
        _offset = 0;
        _length = packet.Length;
    }

    public readonly void SwapValues()
    {
        Span<int> values = MemoryMarshal.Cast<byte, int>(
            _bytes.AsSpan(_offset + ProtocolConstants.HeaderSize, _length - ProtocolConstants.HeaderSize));
        for (int i = 0; i < values.Length; i++)
            values[i] = BinaryPrimitives.ReverseEndianness(values[i]);
    }
}
