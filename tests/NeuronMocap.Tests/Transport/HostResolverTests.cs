using System.Net;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

public sealed class HostResolverTests
{
    // Other tests have timers too, but far fewer.
    [Fact]
    public async Task A_resolved_name_leaves_no_timer()
    {
        const int Names = 5000;
        var options = new LinkOptions("studio", 7001)
        {
            ConnectTimeout = TimeSpan.FromMinutes(5),
            Resolve = static _ => Task.FromResult<IPAddress[]>([IPAddress.Loopback]),
        };
        long before = Timer.ActiveCount;
        for (int i = 0; i < Names; i++)
            Assert.Equal([IPAddress.Loopback], await HostResolver.ResolveAsync(options, TestContext.Current.CancellationToken));

        Assert.InRange(Timer.ActiveCount - before, long.MinValue, Names / 2);
    }
}
