using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Reader;

public sealed class PooledHostileServerTests : HostileServerTests
{
    internal override TcpReceiver CreateReceiver() => new PooledTcpReceiver();
}
