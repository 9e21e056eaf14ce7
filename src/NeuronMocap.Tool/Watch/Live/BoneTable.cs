using System.Numerics;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Figures;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>A page of bones in numbers: positions in the world, and rotations as in the stream.</summary>
internal sealed class BoneTable
{
    public const int HeadHeight = 1;

    private const int Gap = 1;

    private static readonly Padding AfterColumn = new(0, 0, Gap, 0);

    private readonly Pose _pose;
    private readonly IReadOnlyList<Bone> _bones;
    private readonly bool _isWide;
    private readonly int _nameWidth;

    /// <summary>Creates the table.</summary>
    /// <param name="pose">The pose.</param>
    /// <param name="bones">The bones, one for each row.</param>
    /// <param name="isWide">Whether there is room for whole names and decimals of the angles.</param>
    public BoneTable(Pose pose, IReadOnlyList<Bone> bones, bool isWide)
    {
        (_pose, _bones, _isWide) = (pose, bones, isWide);
        _nameWidth = bones.Max(bone => NameOf(bone).Length);
    }

    /// <summary>Width of the table in columns. It does not depend on the numbers, so the skeleton beside it does not move.</summary>
    public int Width => _nameWidth + Gap + (3 * (PositionWidth + Gap)) + (3 * (AngleWidth + Gap));

    private int PositionWidth => _isWide ? 8 : 6;

    private int AngleWidth => _isWide ? 7 : 4;

    public Table Create()
    {
        Table table = new Table().Border(TableBorder.None);
        table.AddColumn(new TableColumn(new Text("bone", Palette.DimStyle)) { NoWrap = true, Width = _nameWidth, Padding = AfterColumn });
        foreach (string axis in (string[])["X", "Y", "Z"])
            table.AddColumn(NumberColumn($"{axis} cm", PositionWidth));
        foreach (char axis in _pose.Format.RotationOrder.ToString())
            table.AddColumn(NumberColumn(_isWide ? $"{axis} deg" : $"{axis}°", AngleWidth));

        foreach (Bone bone in _bones)
            table.AddRow(MakeRow(bone));

        return table;
    }

    private static TableColumn NumberColumn(string title, int width) => new(new Text(title, Palette.DimStyle))
    {
        NoWrap = true,
        Width = width,
        Alignment = Justify.Right,
        Padding = AfterColumn,
    };

    private Text[] MakeRow(Bone bone)
    {
        Vector3 position = _pose.GetPosition(bone);
        Vector3 angles = _pose.GetAngles(bone);
        int decimals = _isWide ? 1 : 0;
        return
        [
            new Text(NameOf(bone), new Style(BodyColours.Of(Wireframe.PartOf(bone)))),
            Number(position.X, 1), Number(position.Y, 1), Number(position.Z, 1),
            Number(angles.X, decimals), Number(angles.Y, decimals), Number(angles.Z, decimals),
        ];
    }

    // L. and R. are short for Left and Right.
    private string NameOf(Bone bone)
    {
        string name = BoneHierarchy.GetName(bone, _pose.Format.Variant);
        return _isWide ? name : Wireframe.PartOf(bone) switch
        {
            BodyPart.Left => $"L.{name["Left".Length..]}",
            BodyPart.Right => $"R.{name["Right".Length..]}",
            _ => name,
        };
    }

    // Values of ten metres or more have no decimals, so that the column keeps its width.
    private static Text Number(float value, int decimals) => new(Quantity.Fixed(value, Math.Abs(value) < 999.9f ? decimals : 0));
}
