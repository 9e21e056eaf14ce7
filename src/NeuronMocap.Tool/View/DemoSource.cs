using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.View;

/// <summary>The simulator inside this process, with its command channel.</summary>
internal sealed class DemoSource : IAsyncDisposable
{
    private readonly Broadcaster _broadcaster;
    private readonly CommandServer _commands;

    private DemoSource(Broadcaster broadcaster, CommandServer commands) => (_broadcaster, _commands) = (broadcaster, commands);

    /// <summary>Where the stream is.</summary>
    public ServerAddress Stream => ServerAddress.Of(_broadcaster.LocalEndPoint!);

    /// <summary>Where the command channel is.</summary>
    public ServerAddress Commands => ServerAddress.Of(_commands.LocalEndPoint!);

    /// <summary>Starts the simulator.</summary>
    /// <exception cref="BroadcasterException">The system has no free port.</exception>
    public static DemoSource Start(RotationOrder? order)
    {
        Broadcaster broadcaster = Broadcaster.StartDemo(rotationOrder: order ?? RotationOrder.YXZ);
        var commands = new CommandServer(broadcaster, new CommandServerOptions { Port = 0 });
        try
        {
            commands.Start();
            return new DemoSource(broadcaster, commands);
        }
        catch
        {
            commands.Dispose();
            broadcaster.Dispose();
            throw;
        }
    }

    public async ValueTask DisposeAsync()
    {
        await _commands.DisposeAsync();
        await _broadcaster.DisposeAsync();
    }
}
