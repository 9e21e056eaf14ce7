using NeuronMocap.Calculation;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>Keeps some thousand rows of calculation data, evenly over a take of any length. The skeleton is measured from them.</summary>
internal sealed class CalculationSample
{
    private const int Most = 4096;

    private readonly List<float[]> _rows = [];
    private long _seen;
    private long _step = 1;

    public int ValueCount { get; private set; }

    public void Add(ReadOnlySpan<float> values)
    {
        if (_seen == 0)
            ValueCount = values.Length;
        if (values.Length != ValueCount)
            return;

        if (_seen % _step == 0)
            _rows.Add(values.ToArray());

        _seen++;
        if (_rows.Count < Most)
            return;

        // Keeps every second row.
        for (int i = 0; i < Most / 2; i++)
            _rows[i] = _rows[2 * i];

        _rows.RemoveRange(Most / 2, Most / 2);
        _step *= 2;
    }

    /// <summary>Measures the skeleton.</summary>
    /// <exception cref="CalculationFormatException">
    /// The rows hold the ends of the bones instead of their centres, or each row has a position that is not a number.
    /// </exception>
    public CalculationSkeleton Measure()
    {
        using var text = new MemoryStream();
        using (var writer = new CalculationFileWriter(text, ValueCount, leaveOpen: true))
        {
            foreach (float[] row in _rows)
                writer.WriteFrame(row);
        }

        return CalculationSkeleton.Measure(CalculationDocument.Parse(text.GetBuffer().AsSpan(0, (int)text.Length)));
    }
}
