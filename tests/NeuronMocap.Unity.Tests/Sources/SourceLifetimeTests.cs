using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Sources;

public sealed class SourceLifetimeTests : SourceFixture
{
    [Fact]
    public void Disabled_while_it_connects_to_a_computer_that_does_not_answer_it_stops_at_once()
    {
        using var hole = new BlackHole();
        AssertQuick(() => Disable(source => source.Port = hole.Port, SourceState.Connecting));
    }

    [Fact]
    public void Disabled_in_every_state_it_stops_at_once()
    {
        using var silent = new TestServer();
        Broadcaster server = Serve(new SyntheticSource());
        (SourceState State, Action<MocapSource> Set)[] cases =
        [
            (SourceState.Connected, source => source.Port = silent.Port),
            (SourceState.Receiving, source => source.Port = server.LocalEndPoint!.Port),
            (SourceState.Waiting, source => source.Port = FreePort()),
            (SourceState.Connected, source => (source.Transport, source.Port) = (TransportKind.Udp, FreePort())),
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
        Assert.Equal(2, server.Statistics.Accepted);
    }

    [Fact]
    public void Kept_through_scenes_it_goes_on_and_a_second_one_is_not_kept()
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

        Assert.Equal(1, server.Statistics.Accepted);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Play_mode_ends_with_nothing_left_and_begins_again(bool reloadDomain)
    {
        Loop.Dispose();
        Loop = new PlayerLoop(play: false);
        Broadcaster server = Serve(new SyntheticSource());
        Add(server);
        double quickest = double.PositiveInfinity;
        for (int i = 1; i <= 3; i++)
        {
            Loop.EnterPlayMode(reloadDomain);
            MocapSource source = Assert.Single(MocapSource.All);
            WaitForPose(source);
            Assert.Equal(i, server.Statistics.Accepted);
            quickest = Math.Min(quickest, Measure(Loop.ExitPlayMode));
            Assert.Empty(MocapSource.All);
            MeasureStop();
        }

        Assert.InRange(quickest, 0, Quick);

        Assert.DoesNotContain(ConsoleLog.Entries, static entry => entry.Type is LogType.Error or LogType.Exception);
    }

    [Fact]
    public void The_end_of_the_program_closes_what_is_open()
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
    public void New_scripts_in_play_mode_open_it_again()
    {
        Broadcaster server = Serve(new SyntheticSource());
        MocapSource source = Add(server);
        WaitForPose(source);
        Loop.ReloadDomain();
        WaitForPose(source);
        Assert.Equal(2, server.Statistics.Accepted);
        Loop.RunUntil(() => server.Statistics.Clients == 1);
    }

    [Fact]
    public void Opened_and_closed_by_a_script_it_does_as_it_is_told()
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
        Assert.Equal(2, server.Statistics.Accepted);
    }

    private double Disable(Action<MocapSource> set, SourceState state)
    {
        MocapSource source = Add(set);
        Loop.RunUntil(() => source.State == state);
        return Math.Max(Measure(() => source.enabled = false), MeasureStop());
    }

    // Threads, sockets and files: a connection's end is that of all of them.
    private static double MeasureStop()
    {
        Assert.Equal(0, SourceConnections.Count);
        return Measure(static () => Assert.True(SourceConnections.Closed.Wait(Limits.Unexpected)));
    }
}
