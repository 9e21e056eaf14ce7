using System.Globalization;
using NeuronMocap.RabbitMq.Connecting;

namespace NeuronMocap.RabbitMq;

/// <summary>Options of a <see cref="RabbitMqPublisher"/>. The values are copied when it is created.</summary>
public sealed class RabbitMqPublisherOptions : RabbitMqOptions
{
    internal const string Names = "stage, stream or exchange";

    private const int MaxCapacity = 1 << 20;

    /// <summary>
    /// Largest size of the stream in bytes; the broker then removes its oldest part. Null, the default, for no limit. The broker removes segments of a quarter
    /// of this size, and of 1 MB to 500 MB, so the stream can be larger by one segment. A stream that exists keeps its limit and its segments, and other
    /// values fail. A motion packet with displacement needs about 1.7 KB.
    /// </summary>
    public long? StreamMaxBytes { get; set; }

    /// <summary>
    /// Largest number of frames that wait for the broker or its confirmations: 1 to 1,048,576. If more arrive, the oldest waiting frame is dropped and
    /// counted. The default is 8192, about 13 MB, or 1.3 s of 100 avatars at 60 Hz.
    /// </summary>
    public int Capacity { get; set; } = 8192;

    /// <summary>When to connect again. The first attempt is always made, and its failure is reported to the caller.</summary>
    public ReconnectPolicy Reconnect { get; private set; } = new();

    /// <summary>
    /// Longest time that the publisher spends at its end on frames that the broker has not received or confirmed: 0 to 5 minutes. The default is 5 s.
    /// </summary>
    public TimeSpan CloseTimeout { get; set; } = TimeSpan.FromSeconds(5);

    internal override IEnumerable<(string Name, string? Value)> Parameters =>
        [("stage", Stage), ("stream", Stream), ("exchange", OtherExchange)];

    /// <summary>Makes options from the address of a broker.</summary>
    /// <param name="address">
    /// <c>amqp://USER:PASSWORD@HOST:PORT/VHOST?stage=NAME&amp;stream=NAME</c>. Everything but the host may be left out. Write special characters as in
    /// web addresses: <c>%2F</c> for a slash.
    /// </param>
    /// <returns>New options.</returns>
    /// <exception cref="FormatException">The text is not such an address. The message says why, without the password.</exception>
    public static RabbitMqPublisherOptions Parse(string address)
    {
        ArgumentNullException.ThrowIfNull(address);
        var options = new RabbitMqPublisherOptions();
        AmqpAddress.Read(address, options, Names, options.TrySet);
        return options.FindFault() is { } fault ? throw new FormatException(fault) : options;
    }

    internal RabbitMqPublisherOptions Copy()
    {
        var copy = (RabbitMqPublisherOptions)MemberwiseClone();
        copy.Reconnect = Reconnect.Copy();
        return copy;
    }

    internal override string? FindFault()
    {
        if (base.FindFault() is { } fault)
            return fault;
        if (StreamMaxBytes is <= 0)
            return "StreamMaxBytes must be more than 0, or null.";
        if (StreamMaxBytes is not null && Stream is null)
            return "StreamMaxBytes needs a Stream.";
        if (Capacity is < 1 or > MaxCapacity)
            return string.Format(CultureInfo.InvariantCulture, "Capacity is {0}; it must be 1 to {1:N0} frames.", Capacity, MaxCapacity);
        if (CloseTimeout < TimeSpan.Zero || CloseTimeout > TimeSpan.FromMinutes(5))
            return $"CloseTimeout is {CloseTimeout}; it must be 0 to 5 minutes.";

        return Reconnect.FindFault();
    }
}
