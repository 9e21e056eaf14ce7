using System.Globalization;
using RabbitMQ.Client;

namespace NeuronMocap.RabbitMq;

/// <summary>Where a source begins in a stream.</summary>
public readonly record struct RabbitMqStreamStart
{
    // The broker looks up times of its own clock, and the publisher's may be ahead.
    private const long ClockMarginSeconds = 5 * 60;

    private const long TicksPerMicrosecond = TimeSpan.TicksPerMillisecond / 1000;

    private readonly string? _word;
    private readonly long? _offset;
    private readonly DateTimeOffset? _time;

    private RabbitMqStreamStart(string? word, long? offset, DateTimeOffset? time) => (_word, _offset, _time) = (word, offset, time);

    /// <summary>The oldest frame that the stream still has. The default.</summary>
    public static RabbitMqStreamStart First => default;

    /// <summary>The last part that the broker has stored, which can be one frame or thousands, and then new frames.</summary>
    public static RabbitMqStreamStart Last => new("last", null, null);

    /// <summary>New frames only.</summary>
    public static RabbitMqStreamStart Next => new("next", null, null);

    /// <summary>A message by its number in the stream.</summary>
    /// <param name="offset">0 or more. <see cref="RabbitMqSourceStatistics.LastOffset"/> is such a number.</param>
    /// <returns>The start.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The number is negative.</exception>
    public static RabbitMqStreamStart AtOffset(long offset) =>
        offset >= 0 ? new(null, offset, null) : throw new ArgumentOutOfRangeException(nameof(offset), offset, "The offset must not be negative.");

    /// <summary>
    /// The first frame that arrived at its publisher's reader at this time or later. The publisher's clock may be up to 5 minutes ahead of the broker's.
    /// </summary>
    /// <param name="time">The time, by the publisher's clock; 1970 or later.</param>
    /// <returns>The start.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The time is before 1970.</exception>
    public static RabbitMqStreamStart AtTime(DateTimeOffset time) => time.ToUnixTimeSeconds() >= 0
        ? new(null, null, time.ToUniversalTime())
        : throw new ArgumentOutOfRangeException(nameof(time), time, "The time must be in 1970 or later.");

    /// <summary>Parses a start.</summary>
    /// <param name="text"><c>first</c>, <c>last</c>, <c>next</c>, a number, or a time with its zone such as <c>2026-05-01T18:30:00Z</c>.</param>
    /// <returns>The start.</returns>
    /// <exception cref="FormatException">The text is none of these.</exception>
    public static RabbitMqStreamStart Parse(string text) => text switch
    {
        "first" => First,
        "last" => Last,
        "next" => Next,
        _ when long.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out long offset) => AtOffset(offset),
        _ when DateTimeOffset.TryParse(text, CultureInfo.InvariantCulture, DateTimeStyles.AssumeUniversal, out DateTimeOffset time)
            && time.ToUnixTimeSeconds() >= 0 => AtTime(time),
        _ => throw new FormatException($"'{text}' is not a start. Use first, last, next, a number, or a time such as 2026-05-01T18:30:00Z."),
    };

    /// <summary>The start in the form that <see cref="Parse"/> takes.</summary>
    /// <returns>The text.</returns>
    public override string ToString() => _time is { } time
        ? time.ToString("yyyy-MM-ddTHH:mm:ss.FFFFFFZ", CultureInfo.InvariantCulture)
        : _offset?.ToString(CultureInfo.InvariantCulture) ?? _word ?? "first";

    // Microseconds since 1970. The broker begins with an earlier part of the stream, so earlier frames arrive, too.
    internal long? EarliestCapture => _time is { } time ? (time.UtcTicks - DateTimeOffset.UnixEpoch.UtcTicks) / TicksPerMicrosecond : null;

    internal static RabbitMqStreamStart AtCapture(long microseconds) =>
        new(null, null, DateTimeOffset.UnixEpoch.AddTicks(microseconds * TicksPerMicrosecond));

    internal object Argument => _time is { } time
        ? new AmqpTimestamp(Math.Max(0, time.ToUnixTimeSeconds() - ClockMarginSeconds))
        : _offset is { } offset ? offset : _word ?? "first";
}
