using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Sources;

public sealed class SourceLifetimeTests : SourceFixture
{
    [Fact]
    public void Disabling_while_connecting_stops_at_once()
    {
        using var hole = new BlackHole();
        AssertQuick(() => Disable(source => source.Port = hole.Port, SourceState.Connecting));
    }

    [Fact]
    public void Disabling_in_any_state_stops_at_once()
    {
        using var silent = new TestServer();
        Broadcaster server = Serve(new SyntheticSource());
        (SourceState State, Action<MocapSource> Set)[] cases =
        [
            (SourceState.Connected, source => source.Port = silent.Port),
            (SourceState.Receiving, source => source.Port = server.LocalEndPoint!.Port),
            (SourceState.Waiting, source => source.Port = FreePort.Next()),
            (SourceState.Connected, source => (source.Transport, source.Port) = (TransportKind.Udp, FreePort.Next())),
            (SourceState.Receiving, source => source.Kind = SourceKind.Simulator),
            (SourceState.Connecting, source => source.Address = "no such host.invalid"),
            (SourceState.Failed, source => source.Port = 0),
        ];
        foreach ((SourceState state, Action<MocapSource> set) in cases)
            AssertQuick(() => Disable(set, state));
    }

    [Fact]
    public void A_scene_change_closes_it_and_the_next_scene_opens_its_own()
    {
        Broadcaster server = Serve(new SyntheticSource());
        MocapSource first = Add(server);
        WaitForPose(first);
        MocapSource? second = null;
        Loop.ChangeScene("Next", () => second = Add(server));

        Assert.True(first == null);
        WaitForPose(second!);
        Assert.Equal(2, server.GetStatistics().Accepted);
    }

    [Fact]
    public void A_source_kept_across_scenes_continues_alone()
    {
        Broadcaster server = Serve(new SyntheticSource());
        GameObject prefab = Loop.CreatePrefab("Source", root =>
        {
            MocapSource asset = root.AddComponent<MocapSource>();
            (asset.Port, asset.PersistAcrossScenes) = (server.LocalEndPoint!.Port, true);
        });
        MocapSource kept = Object.Instantiate(prefab).GetComponent<MocapSource>();
        WaitForPose(kept);
        for (int i = 0; i < 3; i++)
        {
            Loop.ChangeScene("Next", () => Object.Instantiate(prefab));
            Loop.Frames(2);
            Assert.True(kept);
            Assert.Equal(SourceState.Receiving, kept.State);
            Assert.Equal(2, MocapSource.All.Count);
        }

        Assert.Equal(1, server.GetStatistics().Accepted);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Play_mode_leaves_nothing_and_can_restart(bool reloadDomain)
    {
        Loop.Dispose();
        Loop = new PlayerLoop(play: false);
        Broadcaster server = Serve(new SyntheticSource());
        Add(server);
        double quickest = double.PositiveInfinity;
        for (int i = 1; i <= 3 || (i <= 20 && quickest > Quick); i++)
        {
            Loop.EnterPlayMode(reloadDomain);
            MocapSource source = Assert.Single(MocapSource.All);
            WaitForPose(source);
            Assert.Equal(i, server.GetStatistics().Accepted);
            quickest = Math.Min(quickest, Measure(Loop.ExitPlayMode));
            Assert.Empty(MocapSource.All);
            MeasureStop();
        }

        Assert.InRange(quickest, 0, Quick);

        Assert.DoesNotContain(ConsoleLog.Entries, static entry => entry.Type is LogType.Error or LogType.Exception);
    }

    [Fact]
    public void Quitting_closes_every_source()
    {
        Broadcaster server = Serve(new SyntheticSource());
        Loop.Dispose();
        Loop = new PlayerLoop(play: false);
        Loop.EnterPlayMode(reloadDomain: false);
        MocapSource source = Add(server);
        WaitForPose(source);
        Application.RaiseQuitting();
        MeasureStop();
        Loop.Frames(2);
    }

    [Fact]
    public void Recompiling_in_play_mode_reopens_the_source()
    {
        Broadcaster server = Serve(new SyntheticSource());
        MocapSource source = Add(server);
        WaitForPose(source);
        Loop.ReloadDomain();
        WaitForPose(source);
        Assert.Equal(2, server.GetStatistics().Accepted);
        Loop.RunUntil(() => server.GetStatistics().Clients == 1);
    }

    [Fact]
    public void A_script_can_open_and_close_a_source()
    {
        Broadcaster server = Serve(new SyntheticSource());
        MocapSource source = Add(server);
        source.Open();
        source.Open();
        WaitForPose(source);
        source.Close();
        source.Close();
        Loop.Frames(5);
        Assert.Equal(SourceState.Closed, source.State);
        source.Open();
        WaitForPose(source);
        Assert.Equal(2, server.GetStatistics().Accepted);
    }

    private double Disable(Action<MocapSource> set, SourceState state)
    {
        MocapSource source = Add(set);
        Loop.RunUntil(() => source.State == state);
        return Math.Max(Measure(() => source.enabled = false), MeasureStop());
    }

    // A connection ends when its threads, sockets and files have ended.
    private static double MeasureStop()
    {
        Assert.Equal(0, SourceConnections.Count);
        return Measure(static () => Assert.True(SourceConnections.Closed.Wait(Limits.Unexpected)));
    }
}
