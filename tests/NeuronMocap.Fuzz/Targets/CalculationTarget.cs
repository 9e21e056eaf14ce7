using NeuronMocap.Calculation;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>The input as a calculation export. A result keeps the documented rules, and is the same after it is written and read again.</summary>
internal static class CalculationTarget
{
    private static readonly CalculationReadOptions Strict = new() { Strict = true };

    public static void Run(FuzzInput input)
    {
        CalculationDocument document;
        try
        {
            document = CalculationDocument.Parse(input.Bytes);
        }
        catch (CalculationFormatException refusal)
        {
            WrongResultException.ThrowUnless(refusal.Line > 0 && refusal.Column > 0, "A refusal names no place.");
            input.Digest.Add(refusal.Message);
            throw;
        }

        input.Found += document.FrameCount;
        Describe(document, input);
        CheckStrict(document, input);
        CheckPieces(document, input);
        CheckWritten(document);
        CheckPoses(document, input);
    }

    private static void Describe(CalculationDocument document, FuzzInput input)
    {
        WrongResultException.ThrowUnless(
            document.FrameCount > 0 && document.ValueCount is CalculationFrame.FullValueCount or CalculationFrame.BodyValueCount,
            "There are no rows of a frame's length.");
        for (int i = 0; i < document.FrameCount; i++)
            input.Digest.Add(document.GetValues(i));

        WrongResultException.ThrowUnless(
            document.Repairs.Count == Math.Min(document.RepairCount, CalculationDocument.MaxListedRepairs), "The repairs do not add up.");
        foreach (CalculationRepair repair in document.Repairs)
        {
            WrongResultException.ThrowUnless(repair.Line > 0 && repair.Column > 0, "A repair names no place.");
            input.Digest.Add(repair.Description);
        }

        input.Digest.Add(document.TextFormat.Separator + document.TextFormat.RowEnd + document.TextFormat.LastRowEnd);
        input.Digest.Add((long)document.TextFormat.Decimals);
    }

    // Strict reading rejects exactly the files that tolerant reading repairs.
    private static void CheckStrict(CalculationDocument document, FuzzInput input)
    {
        try
        {
            var strict = CalculationDocument.Parse(input.Bytes, Strict);
            WrongResultException.ThrowUnless(document.RepairCount == 0, "Strict reading did not see what had to be repaired.");
            WrongResultException.ThrowUnless(strict.FrameCount == document.FrameCount, "Strict reading read another number of rows.");
        }
        catch (CalculationFormatException)
        {
            WrongResultException.ThrowUnless(document.RepairCount > 0, "Strict reading refused what needed no repair.");
        }
    }

    // Reads row by row, from a stream that returns pieces.
    private static void CheckPieces(CalculationDocument document, FuzzInput input)
    {
        using var reader = new CalculationFileReader(new FuzzStream(input));
        float[] row = new float[document.ValueCount];
        for (int i = 0; i < document.FrameCount; i++)
            WrongResultException.ThrowUnless(reader.TryReadFrame(row) && FloatBits.AreSame(row, document.GetValues(i)), "Pieces make another row.");

        WrongResultException.ThrowUnless(!reader.TryReadFrame(row), "Pieces make more rows.");
        WrongResultException.ThrowUnless(
            reader.RepairCount == document.RepairCount && reader.Repairs.SequenceEqual(document.Repairs), "Pieces are repaired in another way.");
    }

    private static void CheckWritten(CalculationDocument document)
    {
        using var text = new MemoryStream();
        document.Save(text);
        var again = CalculationDocument.Parse(text.GetBuffer().AsSpan(0, (int)text.Length));
        WrongResultException.ThrowUnless(again.FrameCount == document.FrameCount, "What was written has another number of rows.");
        for (int i = 0; i < document.FrameCount; i++)
            WrongResultException.ThrowUnless(FloatBits.AreSame(document.GetValues(i), again.GetValues(i)), "What was written has other values.");
    }

    private static void CheckPoses(CalculationDocument document, FuzzInput input)
    {
        var skeleton = CalculationSkeleton.Measure(document);
        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        skeleton.CopyLocalTransforms(document.GetValues(0), pose);
        input.Digest.Add(pose[(int)Bone.Head].Rotation.W);
    }
}
