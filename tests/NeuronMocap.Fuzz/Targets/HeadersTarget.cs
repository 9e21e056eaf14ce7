using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>
/// Reads the three headers at every possible place, and at impossible ones. A header that is read and written again stays the same.
/// </summary>
internal static class HeadersTarget
{
    public static void Run(FuzzInput input)
    {
        for (int at = 0; at <= input.Bytes.Length; at++)
        {
            int next = input.Bytes[at..].IndexOf((byte)0xFF);
            if (next > 0)
                Read(input, input.Bytes[(at + input.Random.Below(next))..]);

            at = next < 0 ? input.Bytes.Length : at + next;
            Read(input, input.Bytes[at..]);
            Read(input, input.Bytes.Slice(at, Math.Min(input.Bytes.Length - at, input.Random.Below(ProtocolConstants.HeaderSize + 1))));
        }
    }

    private static void Read(FuzzInput input, ReadOnlySpan<byte> bytes)
    {
        Span<byte> copy = stackalloc byte[ProtocolConstants.HeaderSize];
        copy.Clear();
        if (MotionHeader.TryRead(bytes, out MotionHeader motion))
        {
            motion.Write(copy);
            CheckSize(motion.PacketSize, motion.ValueCount);
            Same(MotionHeader.TryRead(copy, out MotionHeader again) && again == motion, motion);
            AddFields(ref input.Digest, motion);
            input.Found++;
        }

        if (CalculationHeader.TryRead(bytes, out CalculationHeader calculation))
        {
            calculation.Write(copy);
            CheckSize(calculation.PacketSize, calculation.ValueCount);
            Same(CalculationHeader.TryRead(copy, out CalculationHeader again) && again == calculation, calculation);
            AddFields(ref input.Digest, calculation);
            input.Found++;
        }

        if (DataCommandHeader.TryRead(bytes, out DataCommandHeader command))
        {
            command.Write(copy);
            Same(DataCommandHeader.TryRead(copy, out DataCommandHeader again) && again == command, command);
            AddFields(ref input.Digest, command);
            input.Found++;
        }
    }

    public static void AddFields(ref Digest digest, in MotionHeader header)
    {
        AddVersion(ref digest, header.Version);
        digest.Add((long)header.Layout);
        digest.Add((long)header.ValueCount);
        digest.Add(header.HasDisplacement);
        digest.Add(header.HasReference);
        digest.Add((long)header.AvatarIndex);
        AddName(ref digest, header.AvatarName);
        digest.Add(header.FrameIndex ?? -1L);
        digest.Add((long)header.Reserved);
        digest.Add((long)header.Reserved1);
        digest.Add((long)header.Reserved2);
    }

    public static void AddFields(ref Digest digest, in CalculationHeader header)
    {
        AddVersion(ref digest, header.Version);
        digest.Add((long)header.ValueCount);
        digest.Add((long)header.AvatarIndex);
        AddName(ref digest, header.AvatarName);
        digest.Add((long)header.FrameIndex);
        digest.Add((long)header.Reserved1);
        digest.Add((long)header.Reserved2);
        digest.Add((long)header.Reserved3);
    }

    public static void AddFields(ref Digest digest, in DataCommandHeader header)
    {
        WrongResultException.ThrowUnless(header.PayloadSize >= 0, "A payload of {0} bytes cannot be.", header.PayloadSize);
        AddVersion(ref digest, header.Version);
        digest.Add((long)header.CommandId);
        digest.Add((long)header.DataCount);
        digest.Add((long)header.Parameter);
        digest.Add((long)header.Value);
        digest.Add(header.PayloadSize);
    }

    private static void AddVersion(ref Digest digest, DataVersion version)
    {
        digest.Add((version.Major << 24) | (version.Minor << 16) | (version.Revision << 8) | version.Build);
        digest.Add(version.TryGetLayout(out HeaderLayout layout) ? (long)layout : -1);
    }

    private static void AddName(ref Digest digest, AvatarName name)
    {
        Span<byte> bytes = stackalloc byte[ProtocolConstants.AvatarNameSize];
        name.CopyTo(bytes);
        digest.Add(bytes);
    }

    private static void CheckSize(int size, int count) => WrongResultException.ThrowUnless(
        count >= 0 && size == ProtocolConstants.HeaderSize + ((long)count * sizeof(float)), "{0} values do not make a packet of {1} bytes.", count, size);

    private static void Same<T>(bool isSame, T header)
    {
        if (!isSame)
            throw new WrongResultException($"{header} is another one when it is written and read again.");
    }
}
