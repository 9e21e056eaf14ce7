using System.Text;

namespace NeuronMocap.Tool.Plot;

/// <summary>A path of lines through points, in any number of pieces.</summary>
internal sealed class SvgPath
{
    private readonly StringBuilder _data = new();

    public bool IsEmpty => _data.Length == 0;

    public SvgPath MoveTo(double x, double y) => Add('M', x, y);

    public SvgPath LineTo(double x, double y) => Add('L', x, y);

    public SvgPath Close()
    {
        _data.Append('Z');
        return this;
    }

    public override string ToString() => _data.ToString();

    private SvgPath Add(char command, double x, double y)
    {
        _data.Append(command).Append(SvgDrawing.Number(x)).Append(' ').Append(SvgDrawing.Number(y));
        return this;
    }
}
