using System.Runtime.InteropServices;
using NeuronMocap.Bvh;
using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>Reads the same file again in pieces, row by row, and strictly. All results must agree.</summary>
internal static class BvhReading
{
    private static readonly BvhReadOptions Strict = new() { Strict = true };

    /// <summary>Reads a valid file again in pieces.</summary>
    public static void Compare(BvhDocument document, FuzzInput input)
    {
        using var reader = new BvhReader(new FuzzStream(input));
        WrongResultException.ThrowUnless(reader.Hierarchy.ChannelCount == document.ChannelCount, "Pieces have other channels.");
        Span<float> row = new float[document.ChannelCount];
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            bool isSame = reader.TryReadFrame(row)
                && MemoryMarshal.AsBytes(row).SequenceEqual(MemoryMarshal.AsBytes(document.GetValues(frame)));
            WrongResultException.ThrowUnless(isSame, "Pieces make another row.");
        }

        WrongResultException.ThrowUnless(!reader.TryReadFrame(row), "Pieces make more rows.");
        WrongResultException.ThrowUnless(
            reader.RepairCount == document.RepairCount && reader.Repairs.SequenceEqual(document.Repairs), "Pieces are repaired in another way.");
        WrongResultException.ThrowUnless(
            reader.FrameTime == document.FrameTime && reader.TextFormat == document.TextFormat, "Pieces are laid out in another way.");
    }

    /// <summary>Reads a rejected file again in pieces.</summary>
    public static void Compare(BvhFormatException refusal, FuzzInput input)
    {
        try
        {
            using var reader = new BvhReader(new FuzzStream(input));
        }
        catch (BvhFormatException other)
        {
            WrongResultException.ThrowUnless(other.Message == refusal.Message, "Pieces are refused in another way.");
            return;
        }

        throw new WrongResultException("Pieces are read though the whole is refused.");
    }

    /// <summary>Reads a valid file again strictly, whether or not it needed repairs.</summary>
    public static void CompareStrict(BvhDocument document, FuzzInput input)
    {
        try
        {
            BvhDocument strict = BvhDocument.Parse(input.Bytes, Strict);
            WrongResultException.ThrowUnless(
                document.RepairCount == 0 && strict.FrameCount == document.FrameCount, "A strict reading accepts what needs repair.");
        }
        catch (BvhFormatException refusal)
        {
            WrongResultException.ThrowUnless(document.RepairCount > 0, "A strict reading refuses what needs no repair.");
            bool isSamePlace = (refusal.Line, refusal.Column) == (document.Repairs[0].Line, document.Repairs[0].Column);
            WrongResultException.ThrowUnless(isSamePlace, "A strict reading refuses another thing than the first one.");
        }
    }
}
