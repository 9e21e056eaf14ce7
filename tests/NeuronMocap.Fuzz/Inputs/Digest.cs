using System.Runtime.InteropServices;

namespace NeuronMocap.Fuzz.Inputs;

/// <summary>A hash of everything that was added, in order. It is fast but not cryptographic.</summary>
internal struct Digest
{
    private const ulong Prime = 0x9E3779B97F4A7C15;

    public ulong Value { get; private set; }

    public void Add(ulong number) => Value = (ulong.RotateLeft(Value, 23) ^ number) * Prime;

    public void Add(long number) => Add((ulong)number);

    public void Add(bool value) => Add(value ? 1ul : 0);

    public void Add(float number) => Add((ulong)BitConverter.SingleToUInt32Bits(number));

    public void Add(double number) => Add(BitConverter.DoubleToUInt64Bits(number));

    public void Add(ReadOnlySpan<char> text) => Add(MemoryMarshal.AsBytes(text));

    public void Add(ReadOnlySpan<float> numbers) => Add(MemoryMarshal.AsBytes(numbers));

    public void Add(ReadOnlySpan<byte> bytes)
    {
        Add((long)bytes.Length);
        ReadOnlySpan<ulong> words = MemoryMarshal.Cast<byte, ulong>(bytes);
        foreach (ulong word in words)
            Add(word);
        foreach (byte rest in bytes[(words.Length * sizeof(ulong))..])
            Add((ulong)rest);
    }

    public static ulong Of(ReadOnlySpan<byte> bytes)
    {
        Digest digest = default;
        digest.Add(bytes);
        return digest.Value;
    }
}
