using System.Net;
using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Sources;

// A UDP port is free again only after its connection has ended.
public sealed class UdpSourceTests : SourceFixture
{
    [Fact]
    public void Disabling_frees_the_UDP_port_at_once()
    {
        int port = FreePort.Next();
        MocapSource source = Add(source => (source.Transport, source.Port) = (TransportKind.Udp, port));
        Serve(new BroadcasterOptions { Sources = [new SyntheticSource()], UdpDestinations = [new IPEndPoint(IPAddress.Loopback, port)] });
        for (int i = 0; i < 5; i++)
        {
            WaitForPose(source);
            source.enabled = false;
            source.enabled = true;
        }

        WaitForPose(source);
        Assert.Contains($"UDP port {port}", source.StatusMessage, StringComparison.Ordinal);
    }

    // A socket is closed on another thread.
    [Fact]
    public void A_UDP_port_is_opened_after_the_last_connection_has_ended()
    {
        int port = FreePort.Next();
        MocapSource source = Add(source => (source.Transport, source.Port, source.Reconnect) = (TransportKind.Udp, port, false));
        Loop.RunUntil(() => source.State == SourceState.Connected);
        using var isReleased = new ManualResetEventSlim();
        source.Reader!.StatusChanged += status =>
        {
            if (status.State == ConnectionState.Stopped)
                isReleased.Wait(Limits.Unexpected);
        };

        source.Close();
        source.Open();
        Assert.Null(source.Reader);
        Assert.Equal((SourceState.Connecting, $"Connecting to UDP port {port}."), (source.State, source.StatusMessage));

        isReleased.Set();
        Loop.RunUntil(() => source.State == SourceState.Connected);
    }

    [Fact]
    public void A_UDP_source_without_Reconnect_can_be_reopened_at_once()
    {
        int port = FreePort.Next();
        MocapSource source = Add(source => (source.Transport, source.Port, source.Reconnect) = (TransportKind.Udp, port, false));
        var states = new HashSet<SourceState>();
        source.StateChanged += state => states.Add(state);
        for (int i = 0; i < 100; i++)
        {
            Loop.RunUntil(() => source.State is SourceState.Connected or SourceState.Failed);
            source.Close();
            source.Open();

            // A connection that still waits for the port.
            source.Close();
            source.Open();
        }

        Loop.RunUntil(() => source.State is SourceState.Connected or SourceState.Failed);
        Assert.Equal([SourceState.Closed, SourceState.Connecting, SourceState.Connected], states.Order());
        Assert.Empty(ConsoleLog.Entries);
    }
}
