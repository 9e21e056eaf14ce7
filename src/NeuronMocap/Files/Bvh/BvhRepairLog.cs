using System.Runtime.CompilerServices;

namespace NeuronMocap.Bvh;

// A file can be wrong on every line; what is told about it stays short. A strict one takes the first fault for a refusal.
internal sealed class BvhRepairLog(bool isStrict)
{
    private readonly List<BvhRepair> _listed = [];

    public IReadOnlyList<BvhRepair> Listed => _listed;

    public int Count { get; private set; }

    /// <summary>Rows and lines that were left out.</summary>
    public int LeftOutCount { get; private set; }

    private bool IsFull => _listed.Count == BvhDocument.MaxListedRepairs;

    /// <summary>Tells of a repair.</summary>
    /// <param name="place">Where.</param>
    /// <param name="fault">What is wrong: a sentence without its full stop.</param>
    /// <param name="remedy">What was made of it, as its second half.</param>
    public void Add(
        BvhTextPosition place,
        [InterpolatedStringHandlerArgument("")] Description fault,
        [InterpolatedStringHandlerArgument("")] Description remedy)
    {
        if (isStrict)
            throw new BvhFormatException($"{fault.ToString()}.", place.Line, place.Column);

        Count += Count < int.MaxValue ? 1 : 0;
        if (!IsFull)
            _listed.Add(new BvhRepair(place.Line, place.Column, $"{fault.ToString()}; {remedy.ToString()}."));
    }

    /// <summary>Tells of a row or line that is left out; otherwise as <see cref="Add"/>.</summary>
    public void AddLeftOut(
        BvhTextPosition place,
        [InterpolatedStringHandlerArgument("")] Description fault,
        [InterpolatedStringHandlerArgument("")] Description remedy)
    {
        LeftOutCount += LeftOutCount < int.MaxValue ? 1 : 0;
        Add(place, fault, remedy);
    }

    // Puts a description together only where there is room for one more: a file of nothing but faults would else cost hundreds of bytes
    // for each of its own.
    [InterpolatedStringHandler]
    public readonly ref struct Description
    {
        private readonly List<string>? _parts;

        public Description(int literalLength, int formattedCount, BvhRepairLog log, out bool isNeeded)
        {
            isNeeded = !log.IsFull;
            _parts = isNeeded ? [] : null;
        }

        public void AppendLiteral(string text) => _parts!.Add(text);

        public void AppendFormatted(string text) => _parts!.Add(text);

        public void AppendFormatted(ReadOnlySpan<byte> word) => _parts!.Add(BvhWord.Quote(word));

        public void AppendFormatted(long number) => _parts!.Add(number.ToString(System.Globalization.CultureInfo.InvariantCulture));

        public override string ToString() => _parts is null ? "" : string.Concat(_parts);
    }
}
