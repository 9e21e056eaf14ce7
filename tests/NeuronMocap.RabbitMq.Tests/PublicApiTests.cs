using NeuronMocap.Tests.Architecture;

namespace NeuronMocap.RabbitMq.Tests;

public sealed class PublicApiTests
{
    [Fact]
    public void The_public_API_matches_its_file() => PublicSurfaceFile.Check(typeof(RabbitMqSource).Assembly);
}
