using System.Reflection;
using Xunit.Sdk;
using Xunit.v3;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>Specifies how the same bytes arrive.</summary>
public enum Splitting
{
    Whole,
    EverySplitInTwo,
    ByteByByte,
    PiecesOf3,
    PiecesOf7,
    PiecesOf64,
    PiecesOf1024,
}

internal static class Splits
{
    /// <summary>Divides bytes: one list of pieces for each variant of the splitting.</summary>
    public static IEnumerable<IEnumerable<ArraySegment<byte>>> Of(byte[] bytes, Splitting splitting) => splitting switch
    {
        Splitting.Whole => [[new ArraySegment<byte>(bytes)]],
        Splitting.EverySplitInTwo => Enumerable.Range(1, Math.Max(0, bytes.Length - 1)).Select(at => SplitAt(bytes, at)),
        Splitting.ByteByByte => [Pieces(bytes, 1)],
        Splitting.PiecesOf3 => [Pieces(bytes, 3)],
        Splitting.PiecesOf7 => [Pieces(bytes, 7)],
        Splitting.PiecesOf64 => [Pieces(bytes, 64)],
        Splitting.PiecesOf1024 => [Pieces(bytes, 1024)],
        _ => throw new ArgumentOutOfRangeException(nameof(splitting)),
    };

    /// <summary>Divides bytes into pieces of random sizes, most of them small.</summary>
    public static IEnumerable<ArraySegment<byte>> Random(byte[] bytes, Random random)
    {
        for (int start = 0; start < bytes.Length;)
        {
            int size = Math.Min(bytes.Length - start, random.Next(1, 1 << random.Next(1, 12)));
            yield return new ArraySegment<byte>(bytes, start, size);
            start += size;
        }
    }

    private static IEnumerable<ArraySegment<byte>> SplitAt(byte[] bytes, int at) =>
        [new ArraySegment<byte>(bytes, 0, at), new ArraySegment<byte>(bytes, at, bytes.Length - at)];

    private static IEnumerable<ArraySegment<byte>> Pieces(byte[] bytes, int size)
    {
        for (int start = 0; start < bytes.Length; start += size)
            yield return new ArraySegment<byte>(bytes, start, Math.Min(size, bytes.Length - start));
    }
}

/// <summary>Runs a theory once for each <see cref="Splitting"/>, its last parameter. With names, runs it once for each name and splitting.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class EverySplittingAttribute(params string[] names) : DataAttribute
{
    public override ValueTask<IReadOnlyCollection<ITheoryDataRow>> GetData(MethodInfo testMethod, DisposalTracker disposalTracker)
    {
        Splitting[] deliveries = Enum.GetValues<Splitting>();
        ITheoryDataRow[] rows = names.Length == 0
            ? [.. deliveries.Select(splitting => new TheoryDataRow(splitting))]
            : [.. names.SelectMany(name => deliveries.Select(splitting => new TheoryDataRow(name, splitting)))];
        return new(rows);
    }

    public override bool SupportsDiscoveryEnumeration() => true;
}
