using Spectre.Console;

namespace NeuronMocap.Tool.Terminal;

/// <summary>The colours. Nearly everyone can distinguish blue from orange.</summary>
internal static class Palette
{
    public static Color Left => Color.DeepSkyBlue1;

    public static Color Right => Color.Orange1;

    public static Color Middle => Color.Grey93;

    public static Color Ground => Color.Grey39;

    public static Color Dim => Color.Grey62;

    public static Color Warning => Color.Yellow;

    public static Color Bad => Color.Red;

    public static Style DimStyle { get; } = new(Color.Grey62);

    public static Style WarningStyle { get; } = new(Warning);

    public static Style StrongStyle { get; } = new(decoration: Decoration.Bold);

    public static Color Of(ConnectionState state) => state switch
    {
        ConnectionState.Receiving => Color.Green,
        ConnectionState.Created or ConnectionState.Connecting or ConnectionState.Connected => Warning,
        _ => Bad,
    };
}
