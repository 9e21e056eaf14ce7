using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Watch;

/// <summary>The source demo: a server inside this process, on a free TCP port of the loopback address.</summary>
internal sealed class DemoServer : IDisposable
{
    private const double FrameRate = 60;

    private readonly Broadcaster _broadcaster;
    private readonly CommandServer _commands;

    private DemoServer(RotationOrder order)
    {
        _broadcaster = new Broadcaster(new BroadcasterOptions
        {
            Sources = [new SyntheticSource(FrameRate)],
            AvatarNames = ["Demo"],
            Port = 0,
            WaitForClient = true,
            RotationOrder = order,
        });
        _commands = new CommandServer(_broadcaster, new CommandServerOptions { Port = 0 });
        _broadcaster.Start();
    }

    public ServerAddress Address => new(_broadcaster.LocalEndPoint!.Address.ToString(), _broadcaster.LocalEndPoint.Port);

    /// <summary>Starts it.</summary>
    /// <exception cref="BroadcasterException">The system gives no port.</exception>
    public static DemoServer Start(RotationOrder order) => new(order);

    /// <summary>Opens the command channel, too.</summary>
    /// <returns>Where it is.</returns>
    /// <exception cref="BroadcasterException">The system gives no port.</exception>
    public ServerAddress OpenCommands()
    {
        _commands.Start();
        return new ServerAddress(_commands.LocalEndPoint!.Address.ToString(), _commands.LocalEndPoint.Port);
    }

    public void Dispose()
    {
        _commands.Dispose();
        _broadcaster.Dispose();
    }
}
