using NeuronMocap.RabbitMq.Connecting;

namespace NeuronMocap.RabbitMq;

/// <summary>Options of a <see cref="RabbitMqSource"/>. The values are copied when it is created.</summary>
public sealed class RabbitMqSourceOptions : RabbitMqOptions
{
    internal const string Names = "stage, avatar, kind, stream, from or exchange";

    private const int MaxCapacity = 1 << 20;

    /// <summary>Name of the only avatar to receive; null, the default, for all avatars of the stage.</summary>
    public string? Avatar { get; set; }

    /// <summary>The only kind of frames to receive; null, the default, for all kinds.</summary>
    public PacketKind? Kind { get; set; }

    /// <summary>
    /// Where to begin in the stream. The default is <see cref="RabbitMqStreamStart.First"/>: the source receives the stream from its beginning as fast as the
    /// reader takes it, and then live.
    /// </summary>
    public RabbitMqStreamStart From { get; set; } = RabbitMqStreamStart.First;

    /// <summary>
    /// Largest number of frames that wait for this source on the broker: 1 to 1,048,576. If it is slower than the publisher, the broker drops the oldest
    /// ones, and the source counts them. A stream drops nothing. The default is 8192, or 1.3 s of 100 avatars at 60 Hz.
    /// </summary>
    public int QueueCapacity { get; set; } = 8192;

    internal override IEnumerable<(string Name, string? Value)> Parameters =>
    [
        ("stage", Stage),
        ("avatar", Avatar),
        ("kind", Kind is { } kind ? RabbitMqRoutingKey.NameOf(kind) : null),
        ("stream", Stream),
        ("from", Stream is null || From == RabbitMqStreamStart.First ? null : From.ToString()),
        ("exchange", OtherExchange),
    ];

    /// <summary>Makes options from the address of a broker.</summary>
    /// <param name="address">
    /// <c>amqp://USER:PASSWORD@HOST:PORT/VHOST?stage=NAME&amp;avatar=NAME&amp;kind=motion&amp;stream=NAME&amp;from=first</c>. Everything but the host may be
    /// left out. The kinds are <c>motion</c>, <c>calculation</c> and <c>studio-calculation</c>. The start is <c>first</c>, <c>last</c>, <c>next</c>, the
    /// number of a message, or a time such as <c>2026-05-01T18:30:00Z</c>.
    /// </param>
    /// <returns>New options.</returns>
    /// <exception cref="FormatException">The text is not such an address. The message says why, without the password.</exception>
    public static RabbitMqSourceOptions Parse(string address)
    {
        ArgumentNullException.ThrowIfNull(address);
        var options = new RabbitMqSourceOptions();
        bool hasStart = false;
        AmqpAddress.Read(address, options, Names, (name, value) =>
        {
            hasStart |= string.Equals(name, "from", StringComparison.Ordinal);
            return options.TrySet(name, value);
        });
        if (hasStart && options.Stream is null)
            throw new FormatException("'from' needs a stream: live frames have no past. Add stream=NAME.");

        return options.FindFault() is { } fault ? throw new FormatException(fault) : options;
    }

    internal RabbitMqSourceOptions Copy() => (RabbitMqSourceOptions)MemberwiseClone();

    internal override string? FindFault()
    {
        if (base.FindFault() is { } fault)
            return fault;
        if (Kind is not (null or PacketKind.Motion or PacketKind.Calculation or PacketKind.StudioCalculation))
            return $"Kind is {Kind}; it must be Motion, Calculation, StudioCalculation or null.";

        return QueueCapacity is >= 1 and <= MaxCapacity ? null : $"QueueCapacity is {QueueCapacity}; it must be 1 to 1,048,576 frames.";
    }

    internal override bool TrySet(string name, string value)
    {
        switch (name)
        {
            case "avatar":
                Avatar = value;
                return true;
            case "kind":
                Kind = RabbitMqRoutingKey.TryGetKind(value, out PacketKind kind)
                    ? kind
                    : throw new FormatException($"'{value}' is not a kind of frames. Use motion, calculation or studio-calculation.");
                return true;
            case "from":
                From = RabbitMqStreamStart.Parse(value);
                return true;
            default:
                return base.TrySet(name, value);
        }
    }
}
