using Microsoft.Extensions.DependencyInjection;
using NeuronMocap.Tests.Architecture;

namespace NeuronMocap.Hosting.Tests;

public sealed class PublicApiTests
{
    [Fact]
    public void The_public_surface_is_the_one_on_file() =>
        PublicSurfaceFile.Check(typeof(NeuronReaderServiceCollectionExtensions).Assembly);
}
