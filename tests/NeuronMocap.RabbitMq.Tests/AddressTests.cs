namespace NeuronMocap.RabbitMq.Tests;

public sealed class AddressTests
{
    [Fact]
    public void Only_the_host_must_be_given()
    {
        RabbitMqSourceOptions options = RabbitMqSourceOptions.Parse("amqp://broker");

        Assert.Equal(
            ("broker", 5672, "guest", "guest", "/", "main", "neuronmocap"),
            (options.Host, options.Port, options.UserName, options.Password, options.VirtualHost, options.Stage, options.Exchange));
        Assert.Equal("amqp://broker:5672/?stage=main", options.ToString());
    }

    [Fact]
    public void Every_part_can_have_special_characters()
    {
        RabbitMqSourceOptions options = RabbitMqSourceOptions.Parse(
            "amqp://m%40e:p%3Aw%2F@[::1]:5673/my%2Fhost?stage=a%26b&avatar=Dr.%20Who&kind=studio-calculation&stream=take%201&from=17&exchange=e");

        Assert.Equal(("m@e", "p:w/", "::1", 5673, "my/host"), (options.UserName, options.Password, options.Host, options.Port, options.VirtualHost));
        Assert.Equal(("a&b", "Dr. Who", PacketKind.StudioCalculation, "take 1", "e"), (options.Stage, options.Avatar, options.Kind, options.Stream, options.Exchange));
        Assert.Equal(RabbitMqStreamStart.AtOffset(17), options.From);
        Assert.Equal(
            "amqp://[::1]:5673/my%2Fhost?stage=a%26b&avatar=Dr.%20Who&kind=studio-calculation&stream=take%201&from=17&exchange=e", options.ToString());
        Assert.Equal(options.ToString(), RabbitMqSourceOptions.Parse(options.ToString()).ToString());
    }

    [Theory]
    [InlineData("broker")]
    [InlineData("http://broker")]
    [InlineData("amqp://")]
    [InlineData("amqp://me:secret")]
    [InlineData("amqp://me:secret/x")]
    [InlineData("amqp://me:12/secret@broker")]
    [InlineData("amqp://me:12?secret@broker")]
    [InlineData("amqp://me:12?secret@broker=1")]
    [InlineData("amqp://me:12?stage=secret@broker")]
    [InlineData("amqp://me:1@secret@broker")]
    [InlineData("amqp://me:secret@")]
    [InlineData("amqp://me:secret@broker:99999")]
    [InlineData("amqp://me:secret@broker:0")]
    [InlineData("amqp://me:secret@broker/a/b")]
    [InlineData("amqp://me:sec#secret@broker")]
    [InlineData("amqp://me:secret@broker?stage=")]
    [InlineData("amqp://me:secret@broker?stages=x")]
    [InlineData("amqp://me:secret@broker?kind=bvh")]
    [InlineData("amqp://me:secret@broker?stream=x&from=yesterday")]
    [InlineData("amqp://me:secret@broker?from=first")]
    public void A_wrong_address_is_refused_without_its_password(string text)
    {
        FormatException fault = Assert.Throws<FormatException>(() => RabbitMqSourceOptions.Parse(text));

        Assert.DoesNotContain("secret", fault.ToString());
    }

    [Theory]
    [InlineData("first", "first")]
    [InlineData("last", "last")]
    [InlineData("next", "next")]
    [InlineData("0", "0")]
    [InlineData("2026-05-01T18:30:00Z", "2026-05-01T18:30:00Z")]
    [InlineData("2026-05-01T20:30:00.25+02:00", "2026-05-01T18:30:00.25Z")]
    public void A_start_is_read_and_written(string text, string written) => Assert.Equal(written, RabbitMqStreamStart.Parse(text).ToString());

    [Theory]
    [InlineData("Dr. Who", "Dr%2E Who")]
    [InlineData("#*%", "%23%2A%25")]
    [InlineData("", "%")]
    [InlineData("a\nb", "a%0Ab")]
    [InlineData("Zoë", "Zoë")]
    public void Names_are_escaped_in_routing_keys(string name, string word) => Assert.Equal(word, RabbitMqRoutingKey.Escape(name));

    [Fact]
    public void Options_that_cannot_work_are_refused_where_they_are_given()
    {
        Assert.Throws<ArgumentException>(() => new RabbitMqSource(new RabbitMqSourceOptions { Stage = " " }));
        Assert.Throws<ArgumentException>(() => new RabbitMqSource(new RabbitMqSourceOptions { Stage = new string('.', 100) }));
        Assert.Throws<ArgumentException>(() => new RabbitMqSource(new RabbitMqSourceOptions { Kind = PacketKind.Command }));
        Assert.Throws<ArgumentException>(() => new RabbitMqSource(new RabbitMqSourceOptions { QueueCapacity = 0 }));
        using var reader = new NeuronReader(new MemoryStream());
        Assert.Throws<ArgumentException>(() => new RabbitMqPublisher(reader, new RabbitMqPublisherOptions { Capacity = 0 }));
        Assert.Throws<ArgumentException>(() => new RabbitMqPublisher(reader, new RabbitMqPublisherOptions { StreamMaxBytes = 1 }));
        Assert.Throws<ArgumentException>(() => new RabbitMqPublisher(reader, new RabbitMqPublisherOptions { Stream = new string('x', 256) }));
    }
}
