using NeuronMocap.Skeleton;

namespace NeuronMocap.Monitor;

/// <summary>The simulator behind --demo: a server inside this process, on a free port of the loopback address.</summary>
internal sealed class DemoServer : IDisposable
{
    public ServerAddress Address { get; private init; }

    public static DemoServer Start(RotationOrder order) =>
        new() { Address = new ServerAddress("127.0.0.1", 7001 + (int)order) };

    public void Dispose()
    {
    }
}
