using System.Globalization;
using System.Net;
using System.Text;
using NeuronMocap.Unity.EditorTools;

namespace NeuronMocap.Unity.Tests.Editor;

// Draws the inspector of a source for the documentation. It shows the fields and is not a screenshot of Unity, as the picture says.
// NEURONMOCAP_UPDATE_PICTURES=1 rewrites the file.
public class InspectorPictureTests
{
    private const int Width = 620;
    private const int LineHeight = 22;

    [Fact]
    public void The_documented_picture_matches_the_inspector()
    {
        using var world = new EditorWorld();
        ImmediateGui.Draw(world.Inspect(world.AddSource(static _ => { }, "Mocap Source")).OnInspectorGUI);
        string path = Path.Combine(Repository.Root, "unity-package", "Documentation~", "images", "source-inspector.svg");
        if (Environment.GetEnvironmentVariable("NEURONMOCAP_UPDATE_PICTURES") == "1")
        {
            Directory.CreateDirectory(Path.GetDirectoryName(path)!);
            File.WriteAllText(path, Draw("Mocap Source"));
        }

        Assert.Equal(Draw("Mocap Source"), File.ReadAllText(path));
    }

    private static string Draw(string title)
    {
        var lines = new StringBuilder();
        int y = 34;
        Text(lines, 16, y, $"{title} (component)", "#ffffff", bold: true);
        foreach (IGrouping<int, GuiControl> row in EditorWorld.Controls.GroupBy(static control => control.Row))
        {
            y += LineHeight;
            int x = 16;
            foreach (GuiControl control in row)
                x = DrawControl(lines, control, x, y);
        }

        y += 2 * LineHeight;
        Text(lines, 16, y, "A drawing of the inspector's fields, made by the tests. Not a screenshot of Unity.", "#8a8a8a");
        return string.Create(CultureInfo.InvariantCulture, $"<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{Width}\" height=\"{y + 16}\" font-family=\"sans-serif\" "
            + $"font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"#383838\"/>\n{lines}</svg>\n");
    }

    private static int DrawControl(StringBuilder lines, GuiControl control, int x, int y)
    {
        switch (control.Kind)
        {
            case "Property" or "Popup":
                Text(lines, x, y, control.Label, "#c4c4c4");
                Box(lines, 230, y, Width - 246);
                Text(lines, 238, y, control.Value, "#e4e4e4");
                return x;
            case "Button" or "Toggle" when control.Label != DelayPicture.BufferLabel:
                int width = 16 + (control.Label.Length * 7);
                Box(lines, x, y, width);
                Text(lines, x + 8, y, control.Label, "#eeeeee");
                return x + width + 8;
            default:
                Text(lines, x, y, control.Value.Length > 0 && control.Kind == "Label" ? $"{control.Label}: {control.Value}" : control.Label,
                    control.Color is { } color ? ToText(color) : "#d8d8d8");
                return x + 18;
        }
    }

    private static string ToText(Color color) =>
        $"#{(int)(color.r * 255):x2}{(int)(color.g * 255):x2}{(int)(color.b * 255):x2}";

    private static void Box(StringBuilder lines, int x, int y, int width) => lines.Append(
        CultureInfo.InvariantCulture, $"<rect x=\"{x}\" y=\"{y - 14}\" width=\"{width}\" height=\"18\" rx=\"3\" fill=\"#2a2a2a\" stroke=\"#212121\"/>\n");

    private static void Text(StringBuilder lines, int x, int y, string text, string color, bool bold = false) => lines.Append(
        CultureInfo.InvariantCulture, $"<text x=\"{x}\" y=\"{y}\" fill=\"{color}\"{(bold ? " font-weight=\"bold\"" : "")}>{WebUtility.HtmlEncode(text)}</text>\n");
}
