using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Frames;

// The bytes of the packet behind a frame: borrowed from the receive path if the processor can read floats in place, otherwise copied.
// There are none before the first packet and after Expire: every read then throws. This costs only the null check that a span of an array makes anyway.
internal struct FrameData
{
    // 32-bit ARM faults on a misaligned float. After lost or extra bytes in the stream, packets can start at any address.
    private static readonly bool ReadsMisaligned =
        RuntimeInformation.ProcessArchitecture is Architecture.X64 or Architecture.X86 or Architecture.Arm64;

    private byte[]? _bytes;
    private int _offset;
    private int _length;
    private byte[]? _own;
    private bool _wasReadLate;

    // Whether the frame was used after it expired. Set on any thread.
    public readonly bool WasReadLate => _wasReadLate;

    public ReadOnlySpan<byte> Header => Bytes.AsSpan(_offset, ProtocolConstants.HeaderSize);

    public int ValueCount => (WhileValid(_length) - ProtocolConstants.HeaderSize) / sizeof(float);

    public ReadOnlySpan<float> Values => MemoryMarshal.Cast<byte, float>(
        Bytes.AsSpan(_offset + ProtocolConstants.HeaderSize, _length - ProtocolConstants.HeaderSize));

    public ReadOnlySpan<byte> Packet => Bytes.AsSpan(_offset, _length);

    private byte[] Bytes
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _bytes ?? throw ReadLate();
    }

    // Values read from the packet on arrival expire together with the packet.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public T WhileValid<T>(T value) => _bytes is null ? throw ReadLate() : value;

    // Called before the memory is reused. A thread that reads at this moment may still get the packet, or parts of the next one.
    public void Expire() => Volatile.Write(ref _bytes, null);

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

    // Takes a packet whose values already have the byte order of this computer.
    public void Copy(ReadOnlySpan<byte> packet)
    {
        if (_own is null || _own.Length < packet.Length)
            _own = new byte[packet.Length];

        packet.CopyTo(_own);
        _bytes = _own;
        _offset = 0;
        _length = packet.Length;
    }

    public void SwapValues()
    {
        Span<int> values = MemoryMarshal.Cast<byte, int>(
            Bytes.AsSpan(_offset + ProtocolConstants.HeaderSize, _length - ProtocolConstants.HeaderSize));
        for (int i = 0; i < values.Length; i++)
            values[i] = BinaryPrimitives.ReverseEndianness(values[i]);
    }

    private InvalidOperationException ReadLate()
    {
        _wasReadLate = true;
        return new InvalidOperationException(
            "The frame is no longer valid. Its data is reused when the handler returns or the next frame is taken. Call Clone() before that to keep it.");
    }
}
