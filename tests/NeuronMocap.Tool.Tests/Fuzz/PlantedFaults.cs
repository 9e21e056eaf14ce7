using System.Runtime.CompilerServices;
using NeuronMocap.Fuzz;
using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Tool.Tests.Fuzz;

/// <summary>Parsers with one fault wherever two bytes 0xFF follow each other, and some parsers without a fault.</summary>
internal static class PlantedFaults
{
    public static readonly byte[] Trigger = [0xFF, 0xFF];

    public static FuzzTarget Get(string fault) => fault switch
    {
        "none" => Create(fault, _ => { }),
        "refusal" => Create(fault, _ => throw new FormatException()) with { Refusal = typeof(FormatException) },
        "exception" => Create(fault, input => _ = input.Bytes.ToArray()[input.Bytes.Length]),
        "two exceptions" => Create(fault, input => throw (input.Bytes.Length % 2 == 0 ? new FormatException() : new InvalidDataException())),
        "another exception than the refusal" => Create(fault, _ => throw new InvalidDataException()) with { Refusal = typeof(FormatException) },
        "wrong result" => Create(fault, input => WrongResultException.ThrowUnless(input.Found < 0, "{0}", input.Found)),
        "allocation" => Create(fault, input => input.Digest.Add((long)Allocate().Length)),
        "a read behind the end" => Create(fault, input => input.Digest.Add((long)input.Segment.Array![input.Segment.Offset + input.Segment.Count])),
        "a read before the start" => Create(fault, input => input.Digest.Add((long)input.Segment.Array![input.Segment.Offset - 1])),
        "a write to the input" => Create(fault, input => input.Segment.AsSpan()[0]++),
        "a write behind the end" => Create(fault, input => input.Segment.Array![input.Segment.Offset + input.Segment.Count]++),
        _ => throw new ArgumentOutOfRangeException(nameof(fault)),
    };

    /// <summary>A parser that does not return.</summary>
    /// <param name="end">Releases its thread.</param>
    public static FuzzTarget Hang(ManualResetEventSlim end) =>
        Create("hang", _ => end.Wait()) with { TimeLimit = TimeSpan.FromSeconds(2) };

    // An inlined array of which only the length is used is not allocated in optimized code.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static byte[] Allocate() => new byte[1 << 20];

    private static FuzzTarget Create(string name, Action<FuzzInput> fault) => new(name, CorpusKind.Packets, () => input =>
    {
        if (input.Bytes.IndexOf(Trigger) >= 0)
            fault(input);
    });
}
