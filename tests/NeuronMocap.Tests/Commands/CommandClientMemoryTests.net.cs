using NeuronMocap.Commands;

namespace NeuronMocap.Tests.Commands;

public class CommandClientMemoryTests
{
    [Fact]
    public async Task The_token_of_a_queued_call_does_not_keep_a_disposed_client()
    {
        using var server = new CommandScript(static _ => Task.CompletedTask);
        using var application = new CancellationTokenSource();
        List<WeakReference> clients = [];
        for (int i = 0; i < 20; i++)
            clients.Add(await UseAsync(server, application.Token));

        await Limits.UntilAsync(() =>
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
            return clients.Count(static client => client.IsAlive) <= 1; // the runtime may keep the last one in a register
        });
    }

    private static async Task<WeakReference> UseAsync(CommandScript server, CancellationToken cancellationToken)
    {
        NeuronCommandClient client = server.CreateClient();
        Task[] calls = [client.GetRotationOrderAsync(cancellationToken), client.ZeroOutAllAsync(cancellationToken)];
        await client.DisposeAsync();
        foreach (Task call in calls)
            await Assert.ThrowsAsync<ObjectDisposedException>(() => call.Soon());

        return new WeakReference(client);
    }
}
