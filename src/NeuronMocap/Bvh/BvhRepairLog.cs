using System.Runtime.CompilerServices;

namespace NeuronMocap.Bvh;

// A file can be wrong on every line; what is told about it stays short.
internal sealed class BvhRepairLog
{
    private readonly List<BvhRepair> _listed = [];

    public IReadOnlyList<BvhRepair> Listed => _listed;

    public int Count { get; private set; }

    private bool IsFull => _listed.Count == BvhDocument.MaxListedRepairs;

    public void Add(int line, string description)
    {
        Count++;
        if (!IsFull)
            _listed.Add(new BvhRepair(line, description));
    }

    public void Add(int line, [InterpolatedStringHandlerArgument("")] Description description) => Add(line, description.ToString());

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

        public void AppendFormatted(int number) => _parts!.Add(number.ToString(System.Globalization.CultureInfo.InvariantCulture));

        public override string ToString() => _parts is null ? "" : string.Concat(_parts);
    }
}
