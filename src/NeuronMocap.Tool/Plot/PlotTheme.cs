using NeuronMocap.Tool.Figures;

namespace NeuronMocap.Tool.Plot;

/// <summary>The colours and sizes of the drawing.</summary>
/// <remarks>
/// Left is blue and right is vermilion, from the palette of Okabe and Ito. Nearly everyone can distinguish them, and their lightness differs for
/// printing in grey.
/// </remarks>
internal static class PlotTheme
{
    public const string Left = "#0072b2";
    public const string Right = "#d55e00";
    public const string Middle = "#3a3f45";
    public const string Paper = "#ffffff";
    public const string Edge = "#d5d9de";
    public const string Grid = "#e7eaee";
    public const string Axis = "#9aa2ab";
    public const string Ink = "#1f2328";
    public const string Dim = "#656d76";

    public const string Font = "Helvetica Neue, Helvetica, Arial, Liberation Sans, DejaVu Sans, sans-serif";

    public const double TitleSize = 22;
    public const double TextSize = 13;
    public const double LabelSize = 12;
    public const double TickSize = 11;

    public static string Of(BodyPart part) => part switch
    {
        BodyPart.Left => Left,
        BodyPart.Right => Right,
        _ => Middle,
    };
}
