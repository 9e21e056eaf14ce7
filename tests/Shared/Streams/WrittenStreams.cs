namespace NeuronMocap.Tests.Infrastructure;

/// <summary>A stream of every kind of packet, each with the name of the corresponding stream in shared/data.</summary>
internal static class WrittenStreams
{
    public static TheoryData<string> Names =>
        ["new-180", "new-186", "new-354", "new-360", "old-354", "studio-354", "calculation", "mixed", "zero-count", "text", "studio-calculation"];

    // Noise, a first token without its second token, a single byte of a token, and a token split by other bytes.
    private static readonly byte[] Noise = [.. Enumerable.Range(0, 61).Select(static i => (byte)(i * 37)), 0xFF, 0xDD, .. new byte[70]];

    public static StreamFixture Write(string name) => (name switch
    {
        "new-180" => Frames(4, static (encoder, i) => encoder.New(Values(i, 180), (uint)i)),
        "new-186" => Frames(3, static (encoder, i) => encoder.New(Values(i, 186), (uint)i, reference: true)),
        "new-354" => Frames(3, static (encoder, i) => encoder.New(Values(i, 354), (uint)i, displacement: true)),
        "new-360" => Frames(3, static (encoder, i) => encoder.New(Values(i, 360), (uint)i, displacement: true, reference: true)),
        "old-354" => Frames(3, static (encoder, i) => encoder.Old(Values(i, 354), 1, "Old")),
        "studio-354" => Frames(3, Studio),
        "calculation" => new WireEncoder().Calculation(Contacts(Values(0, 338)), 10, 0).Calculation(Contacts(Values(1, 946)), 11, 1),
        "studio-calculation" => new WireEncoder().StudioCalculation(59, 9),
        "text" => Frames(2, static (encoder, i) => encoder.Line(Values(i, 354), i % 2, $"Char0{i % 2}")),
        "zero-count" => new WireEncoder().NewWithoutValues().New(Values(0, 354), 77, displacement: true),
        "mixed" => Mixed(),
        _ => throw new ArgumentOutOfRangeException(nameof(name), name, "There is no stream of this name."),
    }).ToFixture();

    private static WireEncoder Frames(int count, Action<WireEncoder, int> write)
    {
        var encoder = new WireEncoder();
        for (int i = 0; i < count; i++)
            write(encoder, i);

        return encoder;
    }

    // The rotation order 1 and the time 10:11:12, frame 7, in the reserved fields.
    private static void Studio(WireEncoder encoder, int i) =>
        encoder.New(Values(i, 354), (uint)i, 3, "演员一", displacement: true, version: "1.1.0.1", reserved: [1, 0x0A0B0C, 7]);

    private static WireEncoder Mixed() => new WireEncoder()
        .Raw(Noise)
        .New(Values(0, 354), 0, 0, "Alice", displacement: true)
        .New(Values(1, 180), 0, 1, "Bob")
        .Raw(Noise[..64])
        .New(Values(2, 354), 1, 0, "Alice", displacement: true)
        .Calculation(Contacts(Values(3, 338)), 5, 0)
        .New(Values(4, 180), 1, 1, "Bob")
        .Raw([0xFF, 0xDD, 0xFF])
        .New(Values(5, 354), 2, 0, "Alice", displacement: true)
        .Command()
        .New(Values(6, 180), 2, 1, "Bob");

    // Angles and lengths as a suit sends them, including negative zeros and very small numbers.
    private static float[] Values(int frame, int count)
    {
        var random = new Random((1000 * count) + frame);
        float[] values = new float[count];
        for (int i = 0; i < count; i++)
        {
            values[i] = random.Next(8) switch
            {
                0 => 0,
                1 => -0f,
                2 => random.Next(2) == 0 ? 1e-6f : -1e-6f,
                _ => (random.NextSingle() - 0.5f) * 360,
            };
        }

        return values;
    }

    // The flags of a calculation packet: the left foot touches the ground, the right foot does not.
    private static float[] Contacts(float[] values)
    {
        (values[336], values[337]) = (1, 0);
        return values;
    }
}
