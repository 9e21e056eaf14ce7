using System.Net;
using NeuronMocap.Motion;
using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Sources;

public sealed class MocapSourceTests : SourceFixture
{
    [Fact]
    public void A_source_moves_a_figure_in_play_mode()
    {
        MocapSource source = AddSimulator();
        Performer performer = WaitForPose(source);
        Vector3 hips = performer.GetPosition(Bone.Hips);
        Loop.RunUntil(() => (performer.GetPosition(Bone.Hips) - hips).magnitude > 0.02f);

        Assert.True(performer.IsLive);
        Assert.Equal(SourceState.Receiving, source.State);
        Assert.True(source.IsOpen);
        Assert.NotNull(source.Reader);
        Assert.StartsWith("Receiving from the simulator: ", source.StatusMessage, StringComparison.Ordinal);
        Assert.Equal((null, null), (source.Reader!.Status.LocalEndPoint, source.Reader.Status.RemoteEndPoint));
        Assert.InRange(performer.GetPosition(Bone.Head).y, 1, 2);
        Loop.RunUntil(() => source.FrameRate is > 50 and < 70);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void Axes_and_units_match_Unity()
    {
        Broadcaster server = Serve(new ValuesSource(static (_, layout, values) =>
        {
            Array.Clear(values);
            Write(values, layout.GetPositionIndex(Bone.Hips), 100, 90, 50);
            Write(values, layout.GetRotationIndex(Bone.Hips), 30, 0, 0);
            Write(values, layout.GetPositionIndex(Bone.LeftArm), 10, 0, 0);
            Write(values, layout.GetRotationIndex(Bone.LeftArm), 10, 20, 40);
        }));
        Performer performer = WaitForPose(Add(server));

        AssertNear(new Vector3(-1, 0.9f, 0.5f), performer.GetPosition(Bone.Hips));
        AssertNear(Quaternion.Euler(0, -30, 0), performer.GetRotation(Bone.Hips));
        AssertNear(Quaternion.Euler(0, -30, 0) * Quaternion.Euler(20, -10, -40), performer.GetRotation(Bone.LeftArm));
        AssertNear(new Vector3(-1, 0.9f, 0.5f) + (Quaternion.Euler(0, -30, 0) * new Vector3(-0.1f, 0, 0)), performer.GetPosition(Bone.LeftArm));
        Assert.Throws<ArgumentOutOfRangeException>(() => performer.GetPosition((Bone)59));
    }

    [Fact]
    public void Several_performers_are_found_by_number_and_by_name()
    {
        Broadcaster server = Serve(new BroadcasterOptions { Sources = [new SyntheticSource(), new SyntheticSource(avatarIndex: 1)], AvatarNames = ["Anna", "Ben"] });
        MocapSource source = Add(server);
        var joined = new List<string>();
        source.PerformerJoined += performer => joined.Add(performer.Name);
        WaitForPose(source, 1);

        Assert.Equal(["Anna", "Ben"], joined.Order());
        Assert.Equal(2, source.Performers.Count);
        Assert.True(source.TryGetPerformer("ben", out Performer? ben));
        Assert.Equal(1, ben.AvatarIndex);
        Assert.False(source.TryGetPerformer("Carl", out _));
        Assert.False(source.TryGetPerformer(2, out _));
        Assert.True((ben.GetPosition(Bone.Hips) - source.Performers[0].GetPosition(Bone.Hips)).magnitude > 0.5f);
    }

    [Fact]
    public void Equal_settings_share_one_connection()
    {
        Broadcaster server = Serve(new SyntheticSource());
        MocapSource[] sources = [.. Enumerable.Range(0, 10).Select(_ => Add(server))];
        foreach (MocapSource source in sources)
            WaitForPose(source);

        Assert.Equal(1, server.GetStatistics().Accepted);
        Assert.All(sources, source => Assert.Same(sources[0].Reader, source.Reader));

        foreach (MocapSource source in sources[1..])
            source.enabled = false;

        Loop.RunFor(0.1f);
        Assert.Equal(SourceState.Receiving, sources[0].State);
        Assert.Equal(1, server.GetStatistics().Clients);
        sources[0].enabled = false;
        Loop.RunUntil(() => server.GetStatistics().Clients == 0);
        Assert.Equal(1, server.GetStatistics().Accepted);
    }

    [Fact]
    public void Disabling_closes_and_enabling_reopens()
    {
        Broadcaster server = Serve(new SyntheticSource());
        MocapSource source = Add(server);
        var left = new List<Performer>();
        source.PerformerLeft += left.Add;
        Performer first = WaitForPose(source);
        double quickest = double.PositiveInfinity;
        for (int i = 1; i <= 5; i++)
        {
            quickest = Math.Min(quickest, Measure(() => source.enabled = false));
            Assert.Equal(SourceState.Closed, source.State);
            Assert.Empty(source.Performers);
            Assert.Null(source.Reader);
            Assert.Equal(i, left.Count);
            source.enabled = true;
            WaitForPose(source);
        }

        Assert.InRange(quickest, 0, Quick);
        Assert.Same(first, left[0]);
        Assert.Equal(6, server.GetStatistics().Accepted);
    }

    [Fact]
    public void A_restarted_server_is_found_again()
    {
        int port = FreePort.Next();
        var first = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = port });
        first.Start();
        MocapSource source = Add(source => source.Port = port);
        var states = new List<SourceState>();
        source.StateChanged += states.Add;
        source.IdleTimeout = 0.1f;
        Performer performer = WaitForPose(source);

        first.Dispose();
        Loop.RunUntil(() => source.State == SourceState.Waiting && !performer.IsLive);
        Assert.NotEmpty(source.StatusMessage);
        Assert.Equal(0, source.FrameRate);
        Assert.Same(performer, source.Performers[0]);

        Serve(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = port });
        Loop.RunUntil(() => source.State == SourceState.Receiving && performer.IsLive);
        Assert.Same(performer, Assert.Single(source.Performers));
        Assert.Contains(SourceState.Waiting, states);
    }

    [Fact]
    public void A_performer_without_frames_leaves_and_joins_again()
    {
        int port = FreePort.Next();
        Broadcaster server = Serve(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = port });
        MocapSource source = Add(server);
        int joined = 0;
        source.PerformerJoined += _ => joined++;
        Performer performer = WaitForPose(source);
        server.Dispose();
        (source.IdleTimeout, source.LeaveTimeout) = (0.1f, 0.2f);
        Loop.RunUntil(() => source.Performers.Count == 0);
        Assert.False(performer.IsLive);

        // On a busy computer, frames can be so far apart that a performer would leave between them.
        source.IdleTimeout = Stage.Patience;
        Serve(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = port });
        WaitForPose(source);
        Assert.Equal(2, joined);
    }

    [Fact]
    public void A_wrong_address_gives_the_reason()
    {
        MocapSource source = Add(source => source.Port = FreePort.Next());
        Loop.RunUntil(() => source.State == SourceState.Waiting);
        Assert.Equal(ConnectionReason.Refused, source.Reason);
        Assert.Contains("refused", source.StatusMessage, StringComparison.Ordinal);

        source.Address = "no such host.invalid";
        Loop.RunUntil(() => source.Reason == ConnectionReason.HostNotFound);
        Assert.Contains("no such host.invalid", source.StatusMessage, StringComparison.Ordinal);
    }

    [Fact]
    public void An_invalid_setting_is_reported_without_an_exception()
    {
        MocapSource source = Add(static source => source.Port = 0);
        Loop.Frames(2);
        Assert.Equal(SourceState.Failed, source.State);
        Assert.Contains("Port is 0", source.StatusMessage, StringComparison.Ordinal);
        Assert.DoesNotContain("Parameter", source.StatusMessage, StringComparison.Ordinal);

        source.Port = 7001;
        source.LocalAddress = "office";
        Loop.Frames(2);
        Assert.Equal(SourceState.Failed, source.State);
        Assert.Contains("Local Address is 'office'", source.StatusMessage, StringComparison.Ordinal);

        source.LocalAddress = string.Empty;
        source.CommandPort = 7001;
        Loop.Frames(2);
        Assert.Contains("Command Port", source.StatusMessage, StringComparison.Ordinal);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void Only_changed_settings_reopen_a_source()
    {
        Broadcaster first = Serve(new SyntheticSource());
        Broadcaster second = Serve(new SyntheticSource());
        MocapSource source = Add(first);
        WaitForPose(source);
        NeuronReader? reader = source.Reader;
        (source.Delay, source.Resample, source.Interpolation, source.Reconnect) = (100, false, PoseInterpolationMethod.Linear, true);
        Loop.Frames(3);
        Assert.Same(reader, source.Reader);
        Performer performer = WaitForPose(source);
        Assert.True(performer.HasPose);

        source.Port = second.LocalEndPoint!.Port;
        Loop.RunUntil(() => second.GetStatistics().Accepted == 1 && first.GetStatistics().Clients == 0);
        WaitForPose(source);
        Assert.NotSame(reader, source.Reader);
    }

    [Fact]
    public void A_local_address_picks_the_network()
    {
        int port = FreePort.Next();
        MocapSource source = Add(source => (source.Transport, source.Port, source.LocalAddress) = (TransportKind.Udp, port, " 127.0.0.1 "));
        Loop.RunUntil(() => source.Reader?.Status.LocalEndPoint is not null);
        Assert.Equal(new IPEndPoint(IPAddress.Loopback, port), source.Reader!.Status.LocalEndPoint);
    }

    // The first server never returns, and its performer is never removed.
    [Fact]
    public void A_live_performer_is_found_first()
    {
        int port = FreePort.Next();
        MocapSource source = Add(source => (source.Transport, source.Port, source.LeaveTimeout, source.IdleTimeout) = (TransportKind.Udp, port, 0, 0.1f));
        using System.Net.Sockets.UdpClient first = Stage.SenderFrom("127.0.0.11"), second = Stage.SenderFrom("127.0.0.12");
        var to = new IPEndPoint(IPAddress.Loopback, port);
        Performer? found = null;
        Loop.RunUntil(() => Send(first) && source.TryGetPerformer(0, out found) && found.IsLive);
        Assert.Equal(0, found!.Sender);
        Loop.RunUntil(() => Send(second) && source.TryGetPerformer(0, out found) && found.Sender == 1);
        Assert.True(source.TryGetPerformer("Char00", out found) && found.Sender == 1);
        Assert.Equal(2, source.Performers.Count);

        bool Send(System.Net.Sockets.UdpClient sender) => sender.Send(NeuronMocap.Tests.Network.TestPackets.Motion(1), to) > 0;
    }

    [Fact]
    public void A_browser_build_explains_the_alternative()
    {
        Application.platform = RuntimePlatform.WebGLPlayer;
        try
        {
            MocapSource source = AddSimulator();
            Loop.Frames(3);
            Assert.Equal(SourceState.Failed, source.State);
            Assert.Contains("relay", source.StatusMessage, StringComparison.Ordinal);
            Assert.Equal(0, SourceConnections.Count);
        }
        finally
        {
            Application.platform = RuntimePlatform.LinuxEditor;
        }
    }

    [Fact]
    public void A_script_can_configure_a_source_before_it_opens()
    {
        using var server = new TestServer();
        MocapSource source = Add(source => source.Port = server.Port);
        Assert.Equal(0, SourceConnections.Count);
        Loop.Frame();
        Assert.Equal(1, SourceConnections.Count);
        Assert.True(source.IsOpen);
    }

    [Theory]
    [InlineData(SimulatedMotion.TPose)]
    [InlineData(SimulatedMotion.JointByJoint)]
    public void The_simulator_stands_in_the_T_pose_or_bends_one_joint_after_the_other(SimulatedMotion motion)
    {
        Performer performer = WaitForPose(AddSimulator(2, motion), 1);
        if (motion == SimulatedMotion.TPose)
            Loop.RunFor(0.2f);
        else
            Loop.RunUntil(() => Quaternion.Angle(performer.GetRotation(Bone.Hips), Quaternion.identity) > 30);

        foreach (Bone bone in (Bone[])[Bone.Spine, Bone.LeftHand, Bone.RightFoot])
        {
            Quaternion local = performer.LocalPose[(int)bone].Rotation.ToUnityRotation();
            AssertNear(Quaternion.identity, local);
        }
    }

    private static void Write(float[] values, int index, float a, float b, float c) => (values[index], values[index + 1], values[index + 2]) = (a, b, c);

    private static void AssertNear(Vector3 expected, Vector3 actual) => Assert.True((expected - actual).magnitude < 1e-5f, $"{expected} {actual}");

    private static void AssertNear(Quaternion expected, Quaternion actual) => Assert.True(Quaternion.Angle(expected, actual) < 0.05f, $"{expected} {actual}");
}
