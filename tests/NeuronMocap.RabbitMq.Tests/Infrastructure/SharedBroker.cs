using NeuronMocap.RabbitMq.Tests.Infrastructure;
using NeuronMocap.Tests.RabbitMq;

[assembly: AssemblyFixture(typeof(SharedBroker))]

namespace NeuronMocap.RabbitMq.Tests.Infrastructure;

/// <summary>The broker of all tests that do not end it. It starts with the first of them.</summary>
public sealed class SharedBroker : IAsyncDisposable
{
    private readonly Lazy<Task<Broker>> _broker = new(static () => Task.Run(Broker.StartAsync));

    internal async Task<Broker> GetAsync()
    {
        Assert.SkipWhen(Broker.Missing is not null, Broker.Missing ?? string.Empty);
        return await _broker.Value;
    }

    public async ValueTask DisposeAsync()
    {
        if (_broker.IsValueCreated && await Task.WhenAny(_broker.Value) is { IsCompletedSuccessfully: true } started)
            await (await started).DisposeAsync();
    }
}
