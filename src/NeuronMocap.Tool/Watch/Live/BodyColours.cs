using NeuronMocap.Tool.Figures;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>The colours of the body's parts.</summary>
internal static class BodyColours
{
    public static Color Of(BodyPart part) => part switch
    {
        BodyPart.Left => Palette.Left,
        BodyPart.Right => Palette.Right,
        _ => Palette.Middle,
    };
}
