using NeuronMocap.Fuzz.Grammar;

namespace NeuronMocap.Fuzz.Inputs;

/// <summary>Changes an input by its grammar: swaps, doubles, repeats, removes or moves parts, and replaces numbers by extremes.</summary>
internal sealed class GrammarMutator(InputBuffer buffer)
{
    private const int MostCopies = 64;

    private readonly List<Part> _parts = [];

    /// <summary>Makes one change, or none if there are no parts of the chosen kind.</summary>
    public void Change(IGrammar grammar, ref FuzzRandom random)
    {
        _parts.Clear();
        if (random.Below(3) == 0)
        {
            ReplaceNumbers(grammar, ref random);
            return;
        }

        grammar.Split(buffer.Bytes, ref random, _parts);
        if (_parts.Count == 0)
            return;

        int at = random.Below(_parts.Count);
        Part part = _parts[at];
        switch (random.Below(6))
        {
            case 0:
                buffer.Remove(part.Start, part.Length);
                break;
            case 1:
                buffer.Insert(part.Start, buffer.Copy(buffer.Bytes, part.Start, part.Length));
                break;
            case 2:
                Swap(part, _parts[random.Below(_parts.Count)]);
                break;
            case 3: // neighbours
                Swap(part, _parts[Math.Min(at + 1, _parts.Count - 1)]);
                break;
            case 4:
                Repeat(part, 1 + random.Small(MostCopies));
                break;
            default: // all of the kind: a whole column, each second line
                RemoveEach(random.Between(1, 3));
                break;
        }
    }

    // Replaces one number, or all from one on. In a column, it replaces all.
    private void ReplaceNumbers(IGrammar grammar, ref FuzzRandom random)
    {
        grammar.FindNumbers(buffer.Bytes, ref random, _parts);
        if (_parts.Count == 0)
            return;

        ReadOnlySpan<byte> extreme = random.Choose(grammar.Extremes);
        bool isBinary = grammar is RecordingGrammar;
        int first = random.Below(_parts.Count);
        int last = random.Below(4) == 0 ? Math.Min(_parts.Count - 1, first + random.Small(64)) : first;
        for (int i = last; i >= first; i--)
        {
            Part number = _parts[i];
            if (isBinary)
                buffer.Overwrite(number.Start, extreme[..number.Length]);
            else
                buffer.Replace(number.Start, number.Length, extreme);
        }
    }

    private void Swap(Part one, Part other)
    {
        (Part first, Part second) = one.Start <= other.Start ? (one, other) : (other, one);
        if (first.End > second.Start)
            return;

        byte[] early = buffer.Bytes.Slice(first.Start, first.Length).ToArray();
        byte[] late = buffer.Bytes.Slice(second.Start, second.Length).ToArray();
        buffer.Replace(second.Start, second.Length, early);
        buffer.Replace(first.Start, first.Length, late);
    }

    private void Repeat(Part part, int times)
    {
        for (int i = 0; i < times && buffer.Length < FuzzInput.MaxLength / 2; i++)
            buffer.Insert(part.Start, buffer.Copy(buffer.Bytes, part.Start, part.Length));
    }

    private void RemoveEach(int step)
    {
        for (int i = _parts.Count - 1; i >= 0; i -= step)
            buffer.Remove(_parts[i].Start, _parts[i].Length);
    }
}
