using System.Buffers.Binary;
using System.Numerics;

namespace NeuronMocap.Frames;

// A rotation in 48 bits. The largest of the four components follows from the other three, which are within ±1/√2: each of them has 15 bits. The highest
// bits of the first two words say which component is the largest. The last word's highest bit is 0.
internal static class CompactRotation
{
    public const int Size = 6;

    private const int Zero = 16_384;
    private const uint Mask = 0x7FFF;
    private const float SquareRootOf2 = 1.41421356f;
    private const float StepsPerUnit = 16_383 * SquareRootOf2;

    // The largest component is 0.5 or more. This allows for the rounding of the others.
    private const float LeastSquare = 0.249f;

    // Returns false for a rotation of length zero, and for values that are not finite.
    public static bool TryWrite(Span<byte> destination, Quaternion rotation)
    {
        float square = rotation.LengthSquared();
        if (!(square > 1e-6f) || square > float.MaxValue)
            return false;

        (float x, float y, float z, float w) = (rotation.X, rotation.Y, rotation.Z, rotation.W);
        (float first, float second, float third, float largest, uint index) = (y, z, w, x, 0u);
        if (MathF.Abs(y) > MathF.Abs(largest))
            (first, largest, index) = (x, y, 1);
        if (MathF.Abs(z) > MathF.Abs(largest))
            (first, second, largest, index) = (x, y, z, 2);
        if (MathF.Abs(w) > MathF.Abs(largest))
            (first, second, third, largest, index) = (x, y, z, w, 3);

        // Of the two quaternions of a rotation, the one whose largest component is positive.
        float steps = StepsPerUnit / MathF.Sqrt(square);
        if (largest < 0)
            steps = -steps;

        BinaryPrimitives.WriteUInt16LittleEndian(destination[4..], (ushort)Round(third * steps));
        BinaryPrimitives.WriteUInt16LittleEndian(destination[2..], (ushort)(Round(second * steps) | ((index & 2) << 14)));
        BinaryPrimitives.WriteUInt16LittleEndian(destination, (ushort)(Round(first * steps) | ((index & 1) << 15)));
        return true;
    }

    // Returns false for bytes that TryWrite does not write.
    public static bool TryRead(ReadOnlySpan<byte> source, out Quaternion rotation)
    {
        uint word2 = BinaryPrimitives.ReadUInt16LittleEndian(source[4..]);
        uint word1 = BinaryPrimitives.ReadUInt16LittleEndian(source[2..]);
        uint word0 = BinaryPrimitives.ReadUInt16LittleEndian(source);
        float first = ToComponent(word0);
        float second = ToComponent(word1);
        float third = ToComponent(word2);
        float square = 1 - ((first * first) + (second * second) + (third * third));
        if (square < LeastSquare || word2 > Mask)
        {
            rotation = default;
            return false;
        }

        float largest = MathF.Sqrt(square);
        rotation = ((word0 >> 15) | ((word1 >> 15) << 1)) switch
        {
            0 => new Quaternion(largest, first, second, third),
            1 => new Quaternion(first, largest, second, third),
            2 => new Quaternion(first, second, largest, third),
            _ => new Quaternion(first, second, third, largest),
        };
        return true;
    }

    // The sum is positive, so cutting off rounds down.
    private static uint Round(float steps) => (uint)(int)(steps + (Zero + 0.5f));

    private static float ToComponent(uint word) => ((int)(word & Mask) - Zero) * (1 / StepsPerUnit);
}
