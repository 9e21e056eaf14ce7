using NeuronMocap.Compatibility.Callbacks;
using NeuronMocap.Compatibility.Sockets;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Sockets;

public sealed class CommandSocketTests
{
    // A call connects again after a failure, and then the server's computer may be gone. The client would try for longer than the test does.
    [Fact]
    public void A_call_ends_while_the_client_connects()
    {
        using var hole = new BlackHole();
        using var socket = new CommandSocket(owner: this, "127.0.0.1", hole.Port, connectTimeout: TimeSpan.FromMinutes(5));
        bool isAnswered = true;
        var caller = new Thread(() => isAnswered = socket.TryCall(static (client, cancel) => client.ZeroOutAsync(0, cancel))) { IsBackground = true };

        caller.Start();

        Assert.True(caller.Join(Limits.Unexpected));
        Assert.False(isAnswered);
        Assert.Equal(SocketState.OffWork, socket.State);
    }
}
