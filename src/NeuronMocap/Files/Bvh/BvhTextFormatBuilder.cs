using System.Text;

namespace NeuronMocap.Bvh;

// Collects the text layout of a file while it is read.
internal sealed class BvhTextFormatBuilder
{
    private int _offsetDecimals = int.MaxValue;
    private int _valueDecimals = int.MaxValue;

    public bool HasByteOrderMark { get; set; }

    public string? Indentation { get; set; }

    public string? Separator { get; private set; }

    public bool? HasSeparatorAtRowEnd { get; private set; }

    public bool? HasBlankLineAfterMotion { get; set; }

    public string? FrameTimeText { get; set; }

    public void AddOffset(ReadOnlySpan<byte> number) => _offsetDecimals = Math.Min(_offsetDecimals, BvhWord.CountDecimals(number));

    public void BeginRow()
    {
        Separator = null;
        _valueDecimals = int.MaxValue;
    }

    public void AddValue(int decimals, ReadOnlySpan<byte> blanksAfterIt)
    {
        _valueDecimals = Math.Min(_valueDecimals, decimals);
        HasSeparatorAtRowEnd = blanksAfterIt.Length > 0;
        if (blanksAfterIt.Length > 0)
            Separator ??= Encoding.ASCII.GetString(blanksAfterIt);
    }

    public BvhTextFormat Build(string? lineEnd)
    {
        BvhTextFormat usual = BvhTextFormat.AxisNeuron;
        return new BvhTextFormat
        {
            LineEnd = lineEnd ?? usual.LineEnd,
            Indentation = Indentation ?? usual.Indentation,
            Separator = Separator ?? usual.Separator,
            OffsetDecimals = _offsetDecimals == int.MaxValue ? usual.OffsetDecimals : _offsetDecimals,
            ValueDecimals = _valueDecimals == int.MaxValue ? usual.ValueDecimals : _valueDecimals,
            HasSeparatorAtRowEnd = HasSeparatorAtRowEnd ?? usual.HasSeparatorAtRowEnd,
            HasBlankLineAfterMotion = HasBlankLineAfterMotion ?? usual.HasBlankLineAfterMotion,
            HasByteOrderMark = HasByteOrderMark,
            FrameTimeText = FrameTimeText,
        };
    }
}
