using System.Text;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.View;
using NeuronMocap.Tool.View.Control;

namespace NeuronMocap.Tool.Tests.View;

public sealed class ControlHubTests
{
    [Fact]
    public async Task A_message_that_is_made_first_arrives_first()
    {
        await using var hub = new ControlHub(static () => []);
        var options = new ViewOptions(Source.Demo, new ConnectionOptions()) { Port = 0 };
        await using ViewServer server = await ViewServer.StartAsync(options, [hub]);
        using ViewSocket page = await ViewSocket.ConnectAsync(new Uri($"ws://{server.LocalEndPoint}/control"), subprotocol: null, configure: null);
        await Limits.UntilAsync(() => hub.Clients == 1);
        var later = new Thread(() => hub.Send(new ProblemMessage("later")));

        hub.SendCurrent(() =>
        {
            later.Start();

            // The other thread waits now, or has sent its message.
            Assert.True(SpinWait.SpinUntil(() => (later.ThreadState & (ThreadState.WaitSleepJoin | ThreadState.Stopped)) != ThreadState.Running, Limits.Unexpected));
            return new ProblemMessage("first");
        });
        later.Join();

        Assert.Contains("first", Encoding.UTF8.GetString((await page.ReceiveAsync())!), StringComparison.Ordinal);
        Assert.Contains("later", Encoding.UTF8.GetString((await page.ReceiveAsync())!), StringComparison.Ordinal);
    }
}
