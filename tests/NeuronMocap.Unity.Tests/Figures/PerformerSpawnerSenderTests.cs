using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Figures;

// Figures and where their data comes from: several computers that send to one source, and other sources.
public sealed class PerformerSpawnerSenderTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void Figures_of_two_computers_that_send_the_same_number_follow_their_own()
    {
        MocapSource source = AddUdpSource(out IPEndPoint to);
        PerformerSpawner spawner = Stage.AddSpawner(source);
        using UdpClient first = Stage.SenderFrom("127.0.0.11"), second = Stage.SenderFrom("127.0.0.12");
        _loop.RunUntil(() => Send(first, to) && Send(second, to) && spawner.Figures.Count == 2 && spawner.Figures.All(static figure => figure.Driver.IsDriving));

        Assert.Equal([0, 1], spawner.Figures.Select(static figure => figure.Performer.Sender).Order());
        Assert.All(spawner.Figures, static figure => Assert.Same(figure.Performer, figure.Driver.Performer));
    }

    // As when a server moves to another computer. The performer stays, because performers of this source never leave.
    [Fact]
    public void A_figure_does_not_follow_the_performer_of_another_computer()
    {
        MocapSource source = AddUdpSource(out IPEndPoint to);
        PerformerSpawner spawner = Stage.AddSpawner(source);
        spawner.DespawnSeconds = 0;
        using UdpClient first = Stage.SenderFrom("127.0.0.11"), second = Stage.SenderFrom("127.0.0.12");
        _loop.RunUntil(() => Send(first, to) && spawner.Figures.Count == 1 && spawner.Figures[0].Driver.IsDriving);
        _loop.RunUntil(() => Send(second, to) && spawner.Figures.Count == 2 && spawner.Figures[1].Driver.IsDriving && spawner.Figures[0].IsIdle);

        SpawnedFigure left = spawner.Figures[0];
        Assert.Equal(0, left.Performer.Sender);
        Assert.Same(left.Performer, left.Driver.Performer);

        // When the performer has left, there is nobody to follow.
        source.LeaveTimeout = 0.1f;
        _loop.RunUntil(() => Send(second, to) && source.Performers.Count == 1 && spawner.Figures[1].Driver.IsDriving && left.Driver.Performer?.Sender != 0);
        Assert.Null(left.Driver.Performer);
        Assert.Contains("stopped sending", left.Driver.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void A_script_may_change_the_performer_or_the_source_of_a_figure()
    {
        MocapSource source = AddUdpSource(out IPEndPoint to);
        PerformerSpawner spawner = Stage.AddSpawner(source);
        using UdpClient first = Stage.SenderFrom("127.0.0.11"), second = Stage.SenderFrom("127.0.0.12");
        _loop.RunUntil(() => Send(first, to) && Send(first, to, avatar: 1, "Ann") && spawner.Figures.Count == 2);
        _loop.RunUntil(() => Send(first, to, avatar: 1, "Ann") && Send(second, to) && spawner.Figures.Count == 3);
        FigureDriver driver = spawner.Figures[2].Driver;

        driver.PerformerIndex = 1;
        _loop.Frame();
        Assert.Equal((1, 0), (driver.Performer!.AvatarIndex, driver.Performer.Sender));

        (driver.PerformerIndex, driver.PerformerChoice, driver.PerformerName) = (0, PerformerChoice.ByName, "Ann");
        _loop.Frame();
        Assert.Equal((1, 0), (driver.Performer!.AvatarIndex, driver.Performer.Sender));

        MocapSource other = Stage.AddSimulator();
        (driver.PerformerChoice, driver.Source) = (PerformerChoice.ByIndex, other);
        _loop.RunUntil(() => Stage.IsLive(other) && driver.Performer == other.Performers[0]);
    }

    [Fact]
    public void Another_source_replaces_the_figures()
    {
        MocapSource first = Stage.AddSimulator(), second = Stage.AddSimulator(performers: 2);
        PerformerSpawner spawner = Stage.AddSpawner(first);
        _loop.RunUntil(() => spawner.Figures.Count == 1 && spawner.Figures[0].Driver.IsDriving);
        List<SpawnedFigure> left = [];
        spawner.Despawning += left.Add;
        SpawnedFigure old = spawner.Figures[0];

        // A spawner without a source keeps its figures, which rest.
        spawner.Source = null;
        _loop.Frame();
        Assert.True(old.IsIdle);
        Assert.Empty(left);

        spawner.Source = second;
        _loop.RunUntil(() => spawner.Figures.Count == 2 && spawner.Figures.All(static figure => figure.Driver.IsDriving));
        Assert.Equal([old], left);
        Assert.Equal(2, spawner.transform.childCount);
        Assert.All(spawner.Figures, figure =>
        {
            Assert.Same(second, figure.Driver.ActiveSource);
            Assert.Same(figure.Performer, figure.Driver.Performer);
        });
    }

    private static MocapSource AddUdpSource(out IPEndPoint to)
    {
        int port = FreePort.Next();
        to = new IPEndPoint(IPAddress.Loopback, port);
        var source = new GameObject("Source").AddComponent<MocapSource>();
        (source.Transport, source.Port, source.LeaveTimeout, source.IdleTimeout) = (TransportKind.Udp, port, 0, 0.1f);
        return source;
    }

    // Without displacement, so that the sizes are those of a human.
    private static bool Send(UdpClient sender, IPEndPoint to, int avatar = 0, string name = "Char00") => sender.Send(TestPackets.Motion(1, avatar, 180, name), to) > 0;
}
