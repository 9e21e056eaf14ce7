using NeuronMocap.RabbitMq;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>amqp://USER:PASSWORD@HOST:PORT/VHOST?stage=NAME&amp;stream=NAME: publishes to a stage of a RabbitMQ broker.</summary>
/// <param name="Options">The broker, the stage, and the stream.</param>
internal sealed record RabbitMqDestination(RabbitMqPublisherOptions Options) : Destination(Options.ToString())
{
    public const string Scheme = "amqp://";
    public const string Form = "amqp://USER:PASSWORD@HOST";

    public static RabbitMqDestination Parse(string text) => new(RabbitMqPublisherOptions.Parse(text));

    /// <summary>Whether packets of the destination arrive at a source of the same broker.</summary>
    public bool Reaches(RabbitMqOptions source) => source.Port == Options.Port
        && source.Host.Equals(Options.Host, StringComparison.OrdinalIgnoreCase)
        && (source.VirtualHost, source.Exchange, source.Stage) == (Options.VirtualHost, Options.Exchange, Options.Stage);

    public override bool IsSame(Destination other) => other is RabbitMqDestination broker && Reaches(broker.Options);

    public override Outlet Open(NeuronReader reader, bool overwrite)
    {
        var publisher = new RabbitMqPublisher(reader, Options);
        try
        {
            publisher.StartAsync().GetAwaiter().GetResult();
            return new RabbitMqOutlet(publisher, Text, isKept: Options.Stream is not null);
        }
        catch (NeuronConnectionException exception)
        {
            publisher.Dispose();
            throw new RelayException($"{Text}: {exception.Message}");
        }
    }
}
