namespace NeuronMocap.Tests.Infrastructure;

/// <summary>A byte stream that another encoder than the library's has written, and what must come out of it.</summary>
internal sealed record StreamFixture(byte[] Bytes, IReadOnlyList<ExpectedPacket> Expected)
{
    /// <summary>The stream that <see cref="WireEncoder"/> writes for a name of <see cref="WrittenStreams"/>.</summary>
    public static StreamFixture Load(string name) => WrittenStreams.Write(name);
}

/// <summary>One packet of a <see cref="StreamFixture"/>; null is a field that the packet's kind or layout does not carry.</summary>
internal sealed record ExpectedPacket(
    string Type,
    string? Layout,
    int Avatar,
    string Name,
    uint? Index,
    bool? Displacement,
    bool? Reference,
    string? Version,
    uint[]? Reserved,
    float[] Values)
{
    public PacketKind Kind => Type switch
    {
        "frame" => PacketKind.Motion,
        "calculation" => PacketKind.Calculation,
        _ => PacketKind.StudioCalculation,
    };
}
