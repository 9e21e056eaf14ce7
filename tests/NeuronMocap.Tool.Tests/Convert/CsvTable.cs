using System.Globalization;
using System.Numerics;

namespace NeuronMocap.Tool.Tests.Convert;

/// <summary>Reads a table as a program for research does: it skips comments and finds columns by their names.</summary>
internal sealed class CsvTable
{
    private readonly Dictionary<string, int> _columns;
    private readonly string[][] _rows;

    public CsvTable(string path)
    {
        string[] lines = File.ReadAllLines(path);
        Comments = [.. lines.Where(static line => line.StartsWith('#'))];
        string[][] table = [.. lines.Where(static line => !line.StartsWith('#')).Select(static line => line.Split(','))];
        _columns = table[0].Select(static (name, index) => (name, index)).ToDictionary(static column => column.name, static column => column.index);
        _rows = table[1..];
        Assert.All(_rows, row => Assert.Equal(_columns.Count, row.Length));
    }

    public string[] Comments { get; }

    public int RowCount => _rows.Length;

    public string Text(int row, string column) => _rows[row][_columns[column]];

    public double[] Column(string name) => [.. Enumerable.Range(0, RowCount).Select(row => Number(row, name))];

    public double Number(int row, string column) => double.Parse(Text(row, column), CultureInfo.InvariantCulture);

    public Vector3 Position(int row, string bone) =>
        new((float)Number(row, bone + "_x"), (float)Number(row, bone + "_y"), (float)Number(row, bone + "_z"));

    public Quaternion Rotation(int row, string bone) =>
        new((float)Number(row, bone + "_qx"), (float)Number(row, bone + "_qy"), (float)Number(row, bone + "_qz"), (float)Number(row, bone + "_qw"));
}
