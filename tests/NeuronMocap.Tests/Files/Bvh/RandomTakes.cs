using System.Numerics;
using NeuronMocap.Bvh;

namespace NeuronMocap.Tests.Bvh;

/// <summary>Documents of any shape: random trees, channels and orders. They follow from the number of the case.</summary>
internal sealed class RandomTakes(int seed)
{
    private static readonly BvhChannel[] Positions = [BvhChannel.Xposition, BvhChannel.Yposition, BvhChannel.Zposition];
    private static readonly BvhChannel[] Rotations = [BvhChannel.Xrotation, BvhChannel.Yrotation, BvhChannel.Zrotation];

    private readonly Random _random = new(seed);

    /// <summary>Any channels, any number of them, several roots.</summary>
    public BvhHierarchy AnyHierarchy() => Hierarchy(_random.Next(1, 12), () => Shuffled(AllChannels())[.._random.Next(7)]);

    /// <summary>Three rotations in an individual order for each joint, with or without positions.</summary>
    public BvhHierarchy TurningHierarchy() => Hierarchy(
        _random.Next(2, 12), () => _random.Next(2) == 0 ? Shuffled(Rotations) : [.. Positions, .. Shuffled(Rotations)], hasOneRoot: true);

    /// <summary>Floats of any bits.</summary>
    public float[] AnyValues(int count) => Values(count, () => BitConverter.Int32BitsToSingle(_random.Next(int.MinValue, int.MaxValue)));

    /// <summary>A motion: each value changes by a few degrees or centimetres from row to row.</summary>
    public float[] Motion(BvhHierarchy hierarchy, int frames)
    {
        float[] values = Values(hierarchy.ChannelCount * frames, () => (_random.NextSingle() - 0.5f) * 10);
        for (int i = 0; i < hierarchy.ChannelCount; i++)
            values[i] = (_random.NextSingle() - 0.5f) * 360;
        for (int i = hierarchy.ChannelCount; i < values.Length; i++)
            values[i] += values[i - hierarchy.ChannelCount];

        return values;
    }

    public BvhDocument Take(BvhHierarchy hierarchy, int frames) => new(hierarchy, BvhFrameTime.FromFrameRate(_random.Next(24, 200)), Motion(hierarchy, frames));

    public Vector3 Offset() => new(Coordinate(), Coordinate(), Coordinate());

    public BvhTextFormat AnyFormat() => new()
    {
        LineEnd = Pick("\r\n", "\n", "\r"),
        Indentation = Pick("    ", "\t", ""),
        Separator = Pick(" ", "\t", "  "),
        OffsetDecimals = _random.Next(9),
        ValueDecimals = _random.Next(9),
        HasSeparatorAtRowEnd = _random.Next(2) == 0,
        HasBlankLineAfterMotion = _random.Next(2) == 0,
        HasByteOrderMark = _random.Next(2) == 0,
    };

    private static float[] Values(int count, Func<float> value) => [.. Enumerable.Range(0, count).Select(_ => value())];

    private static BvhChannel[] AllChannels() => [.. Positions, .. Rotations, .. Rotations];

    private BvhHierarchy Hierarchy(int count, Func<BvhChannel[]> channels, bool hasOneRoot = false)
    {
        var builder = new BvhHierarchyBuilder();
        var open = new List<BvhJoint>();
        for (int i = 0; i < count; i++)
        {
            int depth = _random.Next(hasOneRoot && i > 0 ? 1 : 0, open.Count + 1);
            open.RemoveRange(depth, open.Count - depth);
            Vector3? end = _random.Next(3) == 0 ? Offset() : null;
            open.Add(builder.Add($"Joint {i} é", depth == 0 ? null : open[^1], Offset(), channels(), end));
        }

        return builder.Build();
    }

    private BvhChannel[] Shuffled(BvhChannel[] channels) => [.. channels.OrderBy(_ => _random.Next())];

    private string Pick(params string[] choices) => choices[_random.Next(choices.Length)];

    private float Coordinate() => MathF.Round((_random.NextSingle() - 0.5f) * 100, _random.Next(5));
}
