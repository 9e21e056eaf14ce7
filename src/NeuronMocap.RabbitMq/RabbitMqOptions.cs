using NeuronMocap.RabbitMq.Connecting;

namespace NeuronMocap.RabbitMq;

/// <summary>What publishers and sources have in common: the broker, the user, and the stage.</summary>
public abstract class RabbitMqOptions
{
    /// <summary>The port of a broker: 5672.</summary>
    public const int DefaultPort = 5672;

    /// <summary>The name of the topic exchange that frames go through, unless an option names another.</summary>
    public const string DefaultExchange = "neuronmocap";

    /// <summary>The name of the stage, unless an option names another.</summary>
    public const string DefaultStage = "main";

    private protected RabbitMqOptions()
    {
    }

    /// <summary>Name or address of the computer that runs the broker. The default is "localhost".</summary>
    public string Host { get; set; } = "localhost";

    /// <summary>Port of the broker, 1 to 65535. The default is <see cref="DefaultPort"/>.</summary>
    public int Port { get; set; } = DefaultPort;

    /// <summary>Name of the user. The default is "guest", whom a broker accepts only from its own computer.</summary>
    public string UserName { get; set; } = "guest";

    /// <summary>Password of the user. The default is "guest". No message, status or name contains it.</summary>
    public string Password { get; set; } = "guest";

    /// <summary>The virtual host of the broker. The default is "/".</summary>
    public string VirtualHost { get; set; } = "/";

    /// <summary>
    /// Name of the topic exchange. It is declared if it does not exist. The default is <see cref="DefaultExchange"/>.
    /// </summary>
    public string Exchange { get; set; } = DefaultExchange;

    /// <summary>
    /// Name of the stage: the first word of the routing key. Publishers with the same stage must have different avatars. The default is
    /// <see cref="DefaultStage"/>.
    /// </summary>
    public string Stage { get; set; } = DefaultStage;

    /// <summary>
    /// Name of a stream that keeps every frame on the broker's disk; null, the default, for live frames only. Publisher and source name the same stream.
    /// </summary>
    /// <remarks>
    /// The publisher declares the stream and binds it to the stage. The broker then confirms each frame, and the publisher sends unconfirmed frames again
    /// after a failure. After a failure, a source continues behind the last frame that it has received. If the stream was deleted and declared again, the
    /// source notices it within about 10 s, and continues with the frames of the new stream.
    /// </remarks>
    public string? Stream { get; set; }

    /// <summary>Longest time to connect and log in: 0.1 s to 5 minutes. The default is 5 s.</summary>
    public TimeSpan ConnectTimeout { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>The address of the broker without user and password, such as <c>amqp://localhost:5672/?stage=main</c>.</summary>
    /// <returns>Text for people. It can be shown and stored.</returns>
    public override string ToString() => AmqpAddress.Format(this);

    internal abstract IEnumerable<(string Name, string? Value)> Parameters { get; }

    private protected string? OtherExchange => string.Equals(Exchange, DefaultExchange, StringComparison.Ordinal) ? null : Exchange;

    internal virtual string? FindFault()
    {
        if (string.IsNullOrWhiteSpace(Host))
            return "Host is empty; it must be the name or address of the broker's computer.";
        if (Port is < 1 or > ushort.MaxValue)
            return $"Port is {Port}; it must be 1 to 65535.";
        if (UserName is null || Password is null)
            return "UserName and Password must not be null.";
        if (string.IsNullOrEmpty(VirtualHost))
            return "VirtualHost is empty; the usual one is \"/\".";
        if (string.IsNullOrEmpty(Exchange) || !AmqpName.Fits(Exchange))
            return $"Exchange must have 1 to {AmqpName.MaxBytes} bytes.";
        if (RabbitMqRoutingKey.FindFaultOfStage(Stage) is { } stage)
            return stage;
        if (Stream is not null && (string.IsNullOrWhiteSpace(Stream) || !AmqpName.Fits(Stream)))
            return $"Stream must have 1 to {AmqpName.MaxBytes} bytes, or be null.";

        return ConnectTimeout >= TimeSpan.FromSeconds(0.1) && ConnectTimeout <= TimeSpan.FromMinutes(5)
            ? null
            : $"ConnectTimeout is {ConnectTimeout}; it must be 0.1 s to 5 minutes.";
    }

    // Takes a part of an address. Returns false if its name is unknown.
    internal virtual bool TrySet(string name, string value)
    {
        switch (name)
        {
            case "stage":
                Stage = value;
                return true;
            case "stream":
                Stream = value;
                return true;
            case "exchange":
                Exchange = value;
                return true;
            default:
                return false;
        }
    }
}
