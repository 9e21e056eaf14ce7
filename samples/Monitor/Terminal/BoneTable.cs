using System.Numerics;
using NeuronMocap.Skeleton;
using Spectre.Console;

namespace NeuronMocap.Monitor.Terminal;

/// <summary>Numbers of a page of bones: where they are in the world, and their rotation as the stream has it.</summary>
internal static class BoneTable
{
    public const int HeadHeight = 1;
    public const int NarrowWidth = 44;
    public const int WideWidth = 64;

    private const int NumberCount = 6;

    public static Table Create(Pose pose, IReadOnlyList<Bone> bones, int width)
    {
        bool isWide = width >= WideWidth;
        Table table = new Table().Border(TableBorder.None).Expand();
        table.AddColumn(Column("bone", Justify.Left, Palette.DimStyle));
        string order = pose.Format.RotationOrder.ToString();
        foreach (string axis in (string[])["X", "Y", "Z"])
            table.AddColumn(Column(isWide ? $"{axis} cm" : $"{axis}cm", Justify.Right, Palette.DimStyle));
        foreach (char axis in order)
            table.AddColumn(Column(isWide ? $"{axis} deg" : $"{axis}°", Justify.Right, Palette.DimStyle));
        if (!isWide)
        {
            foreach (TableColumn column in table.Columns.Take(NumberCount))
                column.PadRight(0);
        }

        foreach (Bone bone in bones)
            table.AddRow(MakeRow(pose, bone, isWide ? 1 : 0));

        return table;
    }

    private static TableColumn Column(string title, Justify alignment, Style style) =>
        new(new Text(title, style)) { NoWrap = true, Alignment = alignment };

    private static Text[] MakeRow(Pose pose, Bone bone, int angleDecimals)
    {
        string name = BoneHierarchy.GetName(bone, pose.Format.Variant);
        BodyPart part = name.StartsWith("Left", StringComparison.Ordinal) ? BodyPart.Left
            : name.StartsWith("Right", StringComparison.Ordinal) ? BodyPart.Right : BodyPart.Middle;
        Vector3 position = pose.GetPosition(bone);
        Vector3 angles = pose.GetAngles(bone);
        return
        [
            new Text(name, new Style(Palette.Of(part))).Ellipsis(),
            Number(position.X, 1), Number(position.Y, 1), Number(position.Z, 1),
            Number(angles.X, angleDecimals), Number(angles.Y, angleDecimals), Number(angles.Z, angleDecimals),
        ];
    }

    private static Text Number(float value, int decimals) => new(Quantity.Fixed(value, decimals));
}
