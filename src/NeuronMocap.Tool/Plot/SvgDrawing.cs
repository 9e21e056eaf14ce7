using System.Globalization;
using System.Text;
using System.Xml;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Plot;

/// <summary>The part of a text that is at its point.</summary>
internal enum TextAnchor
{
    Start,
    Middle,
    End,
}

/// <summary>Writes an SVG picture.</summary>
/// <remarks>
/// The picture has a background, so that it looks the same on a dark page. Styles are attributes, because not every program reads a style sheet. The
/// same calls give the same bytes.
/// </remarks>
internal sealed class SvgDrawing : IDisposable
{
    private const string Namespace = "http://www.w3.org/2000/svg";

    private readonly XmlWriter _xml;

    public SvgDrawing(Stream output, double width, double height, string title)
    {
        _xml = XmlWriter.Create(output, new XmlWriterSettings
        {
            Encoding = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false),
            Indent = true,
            IndentChars = " ",
            NewLineChars = "\n",
            CloseOutput = false,
        });
        _xml.WriteStartDocument();
        _xml.WriteStartElement("svg", Namespace);
        Attribute("width", width);
        Attribute("height", height);
        Attribute("viewBox", $"0 0 {Number(width)} {Number(height)}");
        Attribute("font-family", PlotTheme.Font);
        _xml.WriteElementString("title", Namespace, TerminalText.Clean(title));
        Rectangle(new Box(0.5, 0.5, width - 1, height - 1), PlotTheme.Paper, PlotTheme.Edge);
    }

    /// <summary>Formats a number with at most two decimals and without an exponent, in any culture.</summary>
    public static string Number(double value)
    {
        if (!double.IsFinite(value))
            throw new ArgumentOutOfRangeException(nameof(value), value, "Coordinates must be finite.");

        double rounded = Math.Round(value, 2);
        return (rounded == 0 ? 0 : rounded).ToString("0.##", CultureInfo.InvariantCulture);
    }

    /// <summary>Starts a named group of the picture. <see cref="EndGroup"/> ends it.</summary>
    public void BeginGroup(string name)
    {
        Begin("g");
        Attribute("id", name);
    }

    public void EndGroup() => End();

    public void Text(
        double x, double y, string text, double size = PlotTheme.LabelSize, string fill = PlotTheme.Ink, TextAnchor anchor = TextAnchor.Start, bool bold = false)
    {
        Begin("text");
        Attribute("x", x);
        Attribute("y", y);
        Attribute("font-size", size);
        Attribute("fill", fill);
        if (anchor != TextAnchor.Start)
            Attribute("text-anchor", anchor == TextAnchor.Middle ? "middle" : "end");
        if (bold)
            Attribute("font-weight", "600");

        _xml.WriteString(TerminalText.Clean(text));
        End();
    }

    public void Line(double x1, double y1, double x2, double y2, string stroke, double width = 1)
    {
        Begin("line");
        Attribute("x1", x1);
        Attribute("y1", y1);
        Attribute("x2", x2);
        Attribute("y2", y2);
        Attribute("stroke", stroke);
        Attribute("stroke-width", width);
        End();
    }

    public void Rectangle(Box box, string fill, string? stroke = null, double opacity = 1)
    {
        Begin("rect");
        Attribute("x", box.Left);
        Attribute("y", box.Top);
        Attribute("width", box.Width);
        Attribute("height", box.Height);
        Attribute("fill", fill);
        if (stroke is not null)
            Attribute("stroke", stroke);
        if (opacity < 1)
            Attribute("opacity", opacity);

        End();
    }

    public void Circle(double x, double y, double radius, string fill, string? stroke = null, double strokeWidth = 1)
    {
        Begin("circle");
        Attribute("cx", x);
        Attribute("cy", y);
        Attribute("r", radius);
        Attribute("fill", fill);
        if (stroke is not null)
        {
            Attribute("stroke", stroke);
            Attribute("stroke-width", strokeWidth);
        }

        End();
    }

    /// <summary>Draws the lines of a path.</summary>
    public void Stroke(SvgPath path, string stroke, double width, double opacity = 1)
    {
        if (path.IsEmpty)
            return;

        Begin("path");
        Attribute("d", path.ToString());
        Attribute("fill", "none");
        Attribute("stroke", stroke);
        Attribute("stroke-width", width);
        Attribute("stroke-linecap", "round");
        Attribute("stroke-linejoin", "round");
        if (opacity < 1)
            Attribute("opacity", opacity);

        End();
    }

    public void Fill(SvgPath path, string fill, string stroke)
    {
        Begin("path");
        Attribute("d", path.ToString());
        Attribute("fill", fill);
        Attribute("stroke", stroke);
        Attribute("stroke-linejoin", "round");
        End();
    }

    /// <summary>Completes the picture. After a failed write it writes nothing more, so the first exception reaches the caller.</summary>
    public void Dispose() => _xml.Dispose();

    private void Begin(string element) => _xml.WriteStartElement(element, Namespace);

    private void End() => _xml.WriteEndElement();

    private void Attribute(string name, double value) => Attribute(name, Number(value));

    private void Attribute(string name, string value) => _xml.WriteAttributeString(name, value);
}
