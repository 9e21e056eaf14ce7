using System.Net;
using System.Net.Sockets;
using NeuronMocap.RabbitMq.Connecting;
using NeuronMocap.RabbitMq.Tests.Infrastructure;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.RabbitMq;
using RabbitMQ.Client;
using RabbitMQ.Client.Exceptions;

namespace NeuronMocap.RabbitMq.Tests;

public sealed class RefusalTests(SharedBroker shared)
{
    private const string Secret = "s3cret-word";

    public static TheoryData<string, ConnectionReason, string> Faults => new()
    {
        { "password", ConnectionReason.AccessDenied, "The broker HOST refuses the user 'guest' or the password." },
        { "user", ConnectionReason.AccessDenied, "The broker HOST refuses the user 'nobody' or the password." },
        { "stranger", ConnectionReason.AccessDenied, "The broker HOST does not allow user 'stranger' to use the virtual host '/'." },
        { "vhost", ConnectionReason.NetworkError, "The broker HOST has no virtual host 'studio 2'." },
        { "port", ConnectionReason.Refused, "HOST refused the connection: no broker listens there." },
        { "host", ConnectionReason.HostNotFound, "The host name 'no.such.host.invalid' has no address." },
        { "silent", ConnectionReason.TimedOut, "HOST did not answer as a RabbitMQ broker within 0.5 s." },
        { "suit", ConnectionReason.UnknownFormat, "What listens on HOST is not a RabbitMQ broker, or closed the connection while it started." },
    };

    [Theory]
    [MemberData(nameof(Faults))]
    public async Task A_publisher_and_a_source_say_in_one_sentence_what_is_wrong(string fault, ConnectionReason reason, string expected)
    {
        Broker broker = await shared.GetAsync();
        using TcpListener strange = Listen(fault);
        RabbitMqPublisherOptions publish = Stage.Options(broker, "faults");
        RabbitMqSourceOptions receive = Audience.Options(broker, "faults");
        SetFault(publish, fault, strange);
        SetFault(receive, fault, strange);
        await using var reader = new NeuronReader(new MemoryStream());
        await using var publisher = new RabbitMqPublisher(reader, publish);

        NeuronConnectionException one = await Assert.ThrowsAsync<NeuronConnectionException>(() => publisher.StartAsync(TestContext.Current.CancellationToken).Soon());
        NeuronConnectionException other = await Assert.ThrowsAsync<NeuronConnectionException>(
            () => new RabbitMqSource(receive).OpenAsync(TestContext.Current.CancellationToken).Soon());

        string sentence = expected.Replace("HOST", $"127.0.0.1:{publish.Port}");
        Assert.Equal((reason, sentence), (one.Reason, one.Message));
        Assert.Equal((reason, sentence), (other.Reason, other.Message));
        Assert.Equal(new RabbitMqPublisherStatus(IsConnected: false, sentence), publisher.Status);
        Assert.DoesNotContain(Secret, one + publish.ToString() + other + receive + new RabbitMqSource(receive).Name);
        await publisher.Completion.Soon();
    }

    // The client has limits of its own.
    [Fact]
    public void A_timeout_of_the_client_is_a_timeout_unless_a_reason_is_known()
    {
        var options = new RabbitMqSourceOptions();
        var late = new BrokerUnreachableException(new AggregateException(new TimeoutException("The operation has timed out.")));
        var refused = new BrokerUnreachableException(new TimeoutException("Late.", new SocketException((int)SocketError.ConnectionRefused)));

        Assert.Equal(BrokerFault.TimedOut(options).Message, BrokerFault.Of(late, options).Message);
        Assert.Equal(ConnectionReason.Refused, BrokerFault.Of(refused, options).Reason);
    }

    [Fact]
    public async Task A_reader_tells_the_reason_in_its_status_and_goes_on_when_it_is_gone()
    {
        Broker broker = await shared.GetAsync();
        RabbitMqSourceOptions options = Audience.Options(broker, "later", "later");
        await using var reader = new NeuronReader(new NeuronReaderOptions
        {
            Source = new RabbitMqSource(options),
            Reconnect = { InitialDelay = TimeSpan.FromMilliseconds(10), MaxDelay = TimeSpan.FromMilliseconds(10) },
        });
        reader.Start();

        // Read once: the status says "Connecting" again after 10 ms.
        string message = "";
        await Limits.UntilAsync(() => (message = reader.Status.Message).Contains("has no stream", StringComparison.Ordinal));
        Assert.StartsWith($"Opening amqp://127.0.0.1:{broker.Port}/?stage=later&stream=later failed: The broker", message, StringComparison.Ordinal);
        await using Stage stage = await Stage.StartAsync(broker, "later", "later");
        stage.Write(TestPackets.Motion(0));

        await reader.WaitForFramesAsync(1).Soon();
    }

    [Fact]
    public async Task A_queue_of_the_same_name_that_is_no_stream_is_refused()
    {
        Broker broker = await shared.GetAsync();
        await using IConnection connection = await new ConnectionFactory { HostName = "127.0.0.1", Port = broker.Port }
            .CreateConnectionAsync(TestContext.Current.CancellationToken);
        await using IChannel channel = await connection.CreateChannelAsync(cancellationToken: TestContext.Current.CancellationToken);
        await channel.QueueDeclareAsync("orders", durable: true, exclusive: false, autoDelete: false, cancellationToken: TestContext.Current.CancellationToken);

        NeuronConnectionException one = await Assert.ThrowsAsync<NeuronConnectionException>(() => Stage.StartAsync(broker, "orders", "orders"));
        NeuronConnectionException other = await Assert.ThrowsAsync<NeuronConnectionException>(
            () => new RabbitMqSource(Audience.Options(broker, "orders", "orders")).OpenAsync(TestContext.Current.CancellationToken).Soon());

        Assert.Contains("has a queue or exchange of this name with other settings", one.Message, StringComparison.Ordinal);
        Assert.Contains("has a queue or exchange of this name with other settings", other.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_publisher_starts_once_and_ends_at_any_time()
    {
        Broker broker = await shared.GetAsync();
        await using var reader = new NeuronReader(new MemoryStream());
        var publisher = new RabbitMqPublisher(reader, Stage.Options(broker, "once"));
        Assert.True(publisher.Completion.IsCompleted);
        await publisher.StartAsync(TestContext.Current.CancellationToken);

        await Assert.ThrowsAsync<InvalidOperationException>(() => publisher.StartAsync(TestContext.Current.CancellationToken));
        await publisher.DisposeAsync();
        await publisher.DisposeAsync();
        publisher.Dispose();
        await publisher.Completion.Soon();
        await Assert.ThrowsAsync<InvalidOperationException>(() => publisher.StartAsync(TestContext.Current.CancellationToken));
    }

    [Fact]
    public async Task A_handler_of_the_status_that_throws_does_not_hide_the_reason()
    {
        await using var reader = new NeuronReader(new MemoryStream());
        await using var publisher = new RabbitMqPublisher(reader, new RabbitMqPublisherOptions { Host = "127.0.0.1", Port = FreePort.Next() });
        publisher.StatusChanged += static _ => throw new InvalidOperationException("The window is gone.");

        await Assert.ThrowsAsync<NeuronConnectionException>(() => publisher.StartAsync(TestContext.Current.CancellationToken).Soon());
    }

    private static TcpListener Listen(string fault)
    {
        var listener = new TcpListener(IPAddress.Loopback, FreePort.Next());
        if (fault is "silent" or "suit")
            listener.Start();
        if (fault == "suit")
            _ = ServeAsync(listener);

        return listener;
    }

    // A server of motion, in place of a broker. It ends within what the client takes for a frame.
    private static async Task ServeAsync(TcpListener listener)
    {
        byte[] buffer = new byte[1024];
        while (true)
        {
            using Socket client = await listener.AcceptSocketAsync();
            try
            {
                // The client (7.1) does not notice an end that its reading thread meets before the other one has begun the handshake.
                await client.ReceiveAsync(buffer);
                await client.SendAsync(TestPackets.Motion(0));

                // Reads what the client has sent, because a close would otherwise reset the connection.
                client.Shutdown(SocketShutdown.Send);
                while (await client.ReceiveAsync(buffer) > 0)
                {
                }
            }
            catch (SocketException)
            {
                // The client has reset the connection.
            }
        }
    }

    private static void SetFault(RabbitMqOptions options, string fault, TcpListener strange)
    {
        switch (fault)
        {
            case "password":
                options.Password = Secret;
                break;
            case "user":
                (options.UserName, options.Password) = ("nobody", Secret);
                break;
            case "stranger":
                options.UserName = Broker.Stranger;
                break;
            case "vhost":
                options.VirtualHost = "studio 2";
                break;
            case "host":
                options.Host = "no.such.host.invalid";
                break;
            default:
                options.Port = ((IPEndPoint)strange.LocalEndpoint).Port;
                break;
        }

        if (fault == "silent")
            options.ConnectTimeout = TimeSpan.FromSeconds(0.5);
    }
}
