namespace NeuronMocap.Tests.Infrastructure;

/// <summary>A byte stream written by another encoder than the library's, and its expected packets.</summary>
internal sealed record StreamFixture(byte[] Bytes, IReadOnlyList<ExpectedPacket> Expected)
{
    /// <summary>Loads the stream that <see cref="WireEncoder"/> writes for a name of <see cref="WrittenStreams"/>.</summary>
    public static StreamFixture Load(string name) => WrittenStreams.Write(name);
}

/// <summary>One packet of a <see cref="StreamFixture"/>. Fields that its kind or layout does not carry are null.</summary>
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
