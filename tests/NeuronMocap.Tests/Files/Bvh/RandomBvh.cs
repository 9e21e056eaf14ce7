using System.Globalization;
using System.Numerics;
using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Tests.Protocol;

namespace NeuronMocap.Tests.Bvh;

/// <summary>A random hierarchy with random rows, and a text of them with random layout. It needs no repair.</summary>
internal sealed class RandomBvh
{
    private static readonly string[] Names = ["Hips", "a", "Left Up  Leg", "腰", "Hüfte_2", "mixamorig:Spine", "𝔖𝔭", "1.5", "Offset", "x#y", "Ende"];
    private static readonly string[] LineEnds = ["\n", "\r\n", "\r", "\n\n", " \r\n\t\r\n"];
    private static readonly string[] Blanks = [" ", " ", " ", "\t", "  ", " \t ", "\v\f"];

    private readonly Random _random;
    private readonly StringBuilder _text = new();
    private readonly List<Joint> _joints = [];
    private readonly string _lineEnd;

    public RandomBvh(int seed)
    {
        _random = new Random(seed);
        _lineEnd = Pick(LineEnds);
        _text.Append(_random.Next(4) == 0 ? "\uFEFF" : "");
        Line(Keyword("HIERARCHY"));
        for (int roots = _random.Next(1, 4); roots > 0; roots--)
            WriteJoint(null, _random.Next(1, 8));

        WriteMotion();
        Bytes = Encoding.UTF8.GetBytes(_text.ToString());
    }

    public byte[] Bytes { get; }

    public float[] Values { get; private set; } = [];

    public IReadOnlyList<Joint> Joints => _joints;

    private void WriteJoint(Joint? parent, int depth)
    {
        var channels = (BvhChannel[])[.. Enumerable.Range(0, _random.Next(0, 9)).Select(_ => (BvhChannel)_random.Next(1, 7))];
        var joint = new Joint(Pick(Names), parent, channels) { FirstChannel = _joints.Sum(before => before.Channels.Length) };
        _joints.Add(joint);
        Line($"{Keyword(parent is null ? "ROOT" : "JOINT")}{Blank()}{joint.Name}{(_random.Next(2) == 0 ? "" : Blank())}");
        Line("{");
        joint.Offset = WriteOffset();
        if (channels.Length > 0 || _random.Next(2) == 0)
            Line($"{Keyword("CHANNELS")}{Blank()}{channels.Length}{string.Concat(channels.Select(channel => Blank() + Keyword(channel.ToString())))}");

        bool endsFirst = _random.Next(2) == 0;
        if (endsFirst)
            WriteEndSite(joint);
        for (int children = depth > 0 ? _random.Next(0, 4) : 0; children > 0; children--)
            WriteJoint(joint, depth - 1 - _random.Next(4));
        if (!endsFirst && _random.Next(2) == 0)
            WriteEndSite(joint);

        Line("}");
    }

    private void WriteEndSite(Joint joint)
    {
        Line($"{Keyword("End")}{Blank()}Site");
        Line("{");
        joint.EndSite = WriteOffset();
        Line("}");
    }

    private Vector3 WriteOffset()
    {
        string[] numbers = [Number(), Number(), Number()];
        Line($"{Keyword("OFFSET")}{Blank()}{string.Join(Blank(), numbers)}");
        return new Vector3(Parse(numbers[0]), Parse(numbers[1]), Parse(numbers[2]));
    }

    private void WriteMotion()
    {
        int channels = _joints.Sum(joint => joint.Channels.Length);
        int rows = channels == 0 ? 0 : _random.Next(0, 8);
        Line(Keyword("MOTION"));
        Line($"{Keyword("Frames")}{(_random.Next(2) == 0 ? ":" : " :")}{Blank()}{rows}");
        Line($"{Keyword("Frame")}{Blank()}{Keyword("Time")}:{Blank()}0.008");
        string[] numbers = [.. Enumerable.Range(0, rows * channels).Select(_ => Number())];
        Values = [.. numbers.Select(Parse)];
        for (int row = 0; row < rows; row++)
            Line(string.Join(Blank(), numbers.AsSpan(row * channels, channels).ToArray()));
    }

    private void Line(string text) => _text
        .Append(_random.Next(2) == 0 ? "" : Blank()).Append(text).Append(_random.Next(3) == 0 ? Blank() : "").Append(_lineEnd);

    private string Number()
    {
        double value = (_random.NextDouble() - 0.5) * Math.Pow(10, _random.Next(-8, 8));
        string text = _random.Next(8) switch
        {
            0 => value.ToString("R", CultureInfo.InvariantCulture),
            1 => value.ToString("E" + _random.Next(0, 12), CultureInfo.InvariantCulture),
            2 => ((int)value).ToString(CultureInfo.InvariantCulture),
            3 => value.ToString("F" + _random.Next(0, 20), CultureInfo.InvariantCulture),
            4 => _random.Next(2) == 0 ? "-0.000000" : "-0",
            _ => value.ToString("F6", CultureInfo.InvariantCulture),
        };
        return (text[0] is '-' ? "" : Pick(["", "", "+", "0", "00"])) + text;
    }

    private static float Parse(string number) => ExactDecimal.ToSingle(number);

    private string Keyword(string word) => _random.Next(8) switch
    {
        0 => word.ToUpperInvariant(),
        1 => word.ToLowerInvariant(),
        _ => word,
    };

    private string Blank() => Pick(Blanks);

    private T Pick<T>(T[] items) => items[_random.Next(items.Length)];

    public sealed record Joint(string Name, Joint? Parent, BvhChannel[] Channels)
    {
        public int FirstChannel { get; init; }

        public Vector3 Offset { get; set; }

        public Vector3? EndSite { get; set; }
    }
}
