using System.Runtime.CompilerServices;

namespace NeuronMocap.Bvh;

// Collects repairs. A file can be wrong on every line; the list therefore has a limit. A strict log throws at the first defect.
internal sealed class BvhRepairLog(bool isStrict)
{
    private readonly List<BvhRepair> _listed = [];

    public IReadOnlyList<BvhRepair> Listed => _listed;

    public int Count { get; private set; }

    /// <summary>Number of rows and lines that were skipped.</summary>
    public int LeftOutCount { get; private set; }

    private bool IsFull => _listed.Count == BvhDocument.MaxListedRepairs;

    /// <summary>Adds a repair.</summary>
    /// <param name="place">The position of the defect.</param>
    /// <param name="fault">The defect: a sentence without its full stop.</param>
    /// <param name="remedy">The interpretation: the second half of the sentence.</param>
    public void Add(
        BvhTextPosition place,
        [InterpolatedStringHandlerArgument("")] Description fault,
        [InterpolatedStringHandlerArgument("")] Description remedy) => Add(place, fault, remedy, skipsRow: false);

    /// <summary>Adds the repair of a row or line that is skipped.</summary>
    public void AddLeftOut(
        BvhTextPosition place,
        [InterpolatedStringHandlerArgument("")] Description fault,
        [InterpolatedStringHandlerArgument("")] Description remedy)
    {
        LeftOutCount += LeftOutCount < int.MaxValue ? 1 : 0;
        Add(place, fault, remedy, skipsRow: true);
    }

    private void Add(BvhTextPosition place, Description fault, Description remedy, bool skipsRow)
    {
        if (isStrict)
            throw new BvhFormatException($"{fault.ToString()}.", place.Line, place.Column);

        Count += Count < int.MaxValue ? 1 : 0;
        if (!IsFull)
            _listed.Add(new BvhRepair(place.Line, place.Column, $"{fault.ToString()}; {remedy.ToString()}.") { SkipsRow = skipsRow });
    }

    // Builds a description only while the list has room. Otherwise, a file that consists of defects would cost hundreds of bytes for each of its
    // own.
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
