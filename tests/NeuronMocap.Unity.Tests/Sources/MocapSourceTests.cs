using System.Net;
using NeuronMocap.Motion;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Sources;

public sealed class MocapSourceTests : SourceFixture
{
    [Fact]
    public void Play_and_it_moves()
    {
        MocapSource source = AddSimulator();
        Performer performer = WaitForPose(source);
        Vector3 hips = performer.GetPosition(Bone.Hips);
        Loop.RunUntil(() => (performer.GetPosition(Bone.Hips) - hips).magnitude > 0.02f);

        Assert.True(performer.IsLive);
        Assert.Equal(SourceState.Receiving, source.State);
        Assert.True(source.IsOpen);
        Assert.NotNull(source.Reader);
        Assert.Contains("simulator", source.StatusMessage, StringComparison.Ordinal);
        Assert.DoesNotContain("127.0.0.1", source.StatusMessage, StringComparison.Ordinal);
        Assert.InRange(performer.GetPosition(Bone.Head).y, 1, 2);
        Loop.RunUntil(() => source.FrameRate is > 50 and < 70);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void Axes_and_units_are_those_of_Unity()
    {
        Broadcaster server = Serve(new ValuesSource(static (_, layout, values) =>
        {
            Array.Clear(values);
            Write(values, layout.PositionIndex(Bone.Hips), 100, 90, 50);
            Write(values, layout.RotationIndex(Bone.Hips), 30, 0, 0);
            Write(values, layout.PositionIndex(Bone.LeftArm), 10, 0, 0);
            Write(values, layout.RotationIndex(Bone.LeftArm), 10, 20, 40);
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
        Broadcaster server = Serve(new BroadcasterOptions { Sources = [new SyntheticActor(), new SyntheticActor(avatar: 1)], AvatarNames = ["Anna", "Ben"] });
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
        Broadcaster server = Serve(new SyntheticActor());
        MocapSource[] sources = [.. Enumerable.Range(0, 10).Select(_ => Add(server))];
        foreach (MocapSource source in sources)
            WaitForPose(source);

        Assert.Equal(1, server.Statistics.Accepted);
        Assert.All(sources, source => Assert.Same(sources[0].Reader, source.Reader));

        foreach (MocapSource source in sources[1..])
            source.enabled = false;

        Loop.RunFor(0.1f);
        Assert.Equal(SourceState.Receiving, sources[0].State);
        Assert.Equal(1, server.Statistics.Clients);
        sources[0].enabled = false;
        Loop.RunUntil(() => server.Statistics.Clients == 0);
        Assert.Equal(1, server.Statistics.Accepted);
    }

    [Fact]
    public void Disabled_it_closes_and_enabled_it_opens_again()
    {
        Broadcaster server = Serve(new SyntheticActor());
        MocapSource source = Add(server);
        var left = new List<Performer>();
        source.PerformerLeft += left.Add;
        Performer first = WaitForPose(source);
        for (int i = 1; i <= 5; i++)
        {
            AssertQuick(() => source.enabled = false);
            Assert.Equal(SourceState.Closed, source.State);
            Assert.Empty(source.Performers);
            Assert.Null(source.Reader);
            Assert.Equal(i, left.Count);
            source.enabled = true;
            WaitForPose(source);
        }

        Assert.Same(first, left[0]);
        Assert.Equal(6, server.Statistics.Accepted);
    }

    [Fact]
    public void A_server_that_goes_and_comes_back_is_found_again()
    {
        int port = FreePort();
        var first = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticActor()], Port = port });
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

        Serve(new BroadcasterOptions { Sources = [new SyntheticActor()], Port = port });
        Loop.RunUntil(() => source.State == SourceState.Receiving && performer.IsLive);
        Assert.Same(performer, Assert.Single(source.Performers));
        Assert.Contains(SourceState.Waiting, states);
    }

    [Fact]
    public void A_performer_without_frames_is_gone_after_a_while_and_joins_again()
    {
        Broadcaster server = Serve(new SyntheticActor());
        MocapSource source = Add(server, static source => (source.IdleTimeout, source.GoneTimeout) = (0.1f, 0.2f));
        int joined = 0;
        source.PerformerJoined += _ => joined++;
        Performer performer = WaitForPose(source);
        int port = server.LocalEndPoint!.Port;
        server.Dispose();
        Loop.RunUntil(() => source.Performers.Count == 0);
        Assert.False(performer.IsLive);

        Serve(new BroadcasterOptions { Sources = [new SyntheticActor()], Port = port });
        WaitForPose(source);
        Assert.Equal(2, joined);
    }

    [Fact]
    public void A_wrong_address_gives_the_reason()
    {
        MocapSource source = Add(source => source.Port = FreePort());
        Loop.RunUntil(() => source.State == SourceState.Waiting);
        Assert.Equal(ConnectionReason.Refused, source.Reason);
        Assert.Contains("refused", source.StatusMessage, StringComparison.Ordinal);

        source.Address = "no such host.invalid";
        Loop.RunUntil(() => source.Reason == ConnectionReason.HostNotFound);
        Assert.Contains("no such host.invalid", source.StatusMessage, StringComparison.Ordinal);
    }

    [Fact]
    public void A_setting_that_cannot_be_is_a_sentence_and_no_exception()
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
    public void A_setting_that_is_changed_opens_anew_and_others_do_not()
    {
        Broadcaster first = Serve(new SyntheticActor());
        Broadcaster second = Serve(new SyntheticActor());
        MocapSource source = Add(first);
        WaitForPose(source);
        NeuronReader? reader = source.Reader;
        (source.Delay, source.Resample, source.Smoothing, source.Reconnect) = (100, false, PoseSmoothing.Linear, true);
        Loop.Frames(3);
        Assert.Same(reader, source.Reader);
        Performer performer = WaitForPose(source);
        Assert.True(performer.HasPose);

        source.Port = second.LocalEndPoint!.Port;
        Loop.RunUntil(() => second.Statistics.Accepted == 1 && first.Statistics.Clients == 0);
        WaitForPose(source);
        Assert.NotSame(reader, source.Reader);
    }

    [Fact]
    public void A_local_address_picks_the_network()
    {
        int port = FreeUdpPort();
        MocapSource source = Add(source => (source.Transport, source.Port, source.LocalAddress) = (TransportKind.Udp, port, " 127.0.0.1 "));
        Loop.RunUntil(() => source.Reader?.Status.LocalEndPoint is not null);
        Assert.Equal(new IPEndPoint(IPAddress.Loopback, port), source.Reader!.Status.LocalEndPoint);
    }

    [Theory]
    [InlineData(BroadcastFormat.Studio)]
    [InlineData(BroadcastFormat.Binary)]
    public void A_performer_has_the_timecode_of_its_newest_frame(BroadcastFormat format)
    {
        MocapSource source = Add(Serve(new BroadcasterOptions { Sources = [new SyntheticActor()], Format = format }));
        Performer performer = WaitForPose(source);
        if (format == BroadcastFormat.Studio)
            Loop.RunUntil(() => performer.Timecode is { Hours: < 24, Minutes: < 60, Seconds: < 60 });
        else
            Assert.Null(performer.Timecode);
    }

    [Fact]
    public void Datagrams_are_received_and_the_port_is_free_at_once_when_it_is_disabled()
    {
        int port = FreeUdpPort();
        MocapSource source = Add(source => (source.Transport, source.Port) = (TransportKind.Udp, port));
        Serve(new BroadcasterOptions { Sources = [new SyntheticActor()], UdpDestinations = [new IPEndPoint(IPAddress.Loopback, port)] });
        for (int i = 0; i < 5; i++)
        {
            WaitForPose(source);
            source.enabled = false;
            source.enabled = true;
        }

        WaitForPose(source);
        Assert.Contains($"UDP port {port}", source.StatusMessage, StringComparison.Ordinal);
    }

    [Fact]
    public void Frames_with_values_that_are_no_numbers_are_left_out()
    {
        Broadcaster server = Serve(new ValuesSource(static (frame, _, values) =>
        {
            if (frame % 3 == 0)
                values[frame % values.Length] = frame % 2 == 0 ? float.NaN : float.PositiveInfinity;
            else if (frame % 3 == 1)
                values[0] = 1e30f;
        }));
        MocapSource source = Add(server);
        Performer performer = WaitForPose(source);
        Loop.RunUntil(() =>
        {
            foreach (BoneTransform bone in performer.WorldPose)
                Assert.True(bone.Position.Length() < 1000 && Math.Abs(bone.Rotation.Length() - 1) < 1e-3f);

            return performer.RejectedFrames > 50;
        });
    }

    [Fact]
    public void Sizes_are_learnt_from_the_stream()
    {
        float thigh = 40;
        Broadcaster server = Serve(new ValuesSource((_, layout, values) => values[layout.PositionIndex(Bone.LeftLeg) + 1] = -Volatile.Read(ref thigh)));
        MocapSource source = Add(server);
        Performer performer = WaitForPose(source);
        Assert.Equal(-40, performer.Body.GetOffset(Bone.LeftLeg).Y, 0.001f);
        int version = performer.BodyVersion;

        Loop.RunFor(0.1f);
        Assert.Equal(version, performer.BodyVersion);
        Volatile.Write(ref thigh, 45);
        Loop.RunUntil(() => performer.BodyVersion > version);
        Assert.Equal(-45, performer.Body.GetOffset(Bone.LeftLeg).Y, 0.001f);
    }

    [Fact]
    public void Sizes_are_asked_for_on_the_command_channel_where_the_stream_has_none()
    {
        var tall = SkeletonBody.FromDimensions(SkeletonBody.Default().Measure() with { UpperLeg = 0.6f });
        Broadcaster server = Serve(new BroadcasterOptions { Sources = [new ValuesSource(static (_, _, _) => { }, tall)], Displacement = false });
        using var commands = new CommandServer(server, new CommandServerOptions { Port = 0 });
        commands.Start();
        MocapSource without = Add(server);
        MocapSource with = Add(server, source => source.CommandPort = commands.LocalEndPoint!.Port);
        Performer performer = WaitForPose(with);
        Loop.RunUntil(() => performer.BodyVersion > 0);

        Assert.Equal(60, performer.Body.GetOffset(Bone.LeftLeg).Length(), 0.01f);

        // The pose is a short delay behind.
        Loop.RunUntil(() => Math.Abs((performer.GetPosition(Bone.LeftLeg) - performer.GetPosition(Bone.LeftUpLeg)).magnitude - 0.6f) < 1e-4f);
        Assert.Same(SkeletonBody.Default(), WaitForPose(without).Body);
    }

    [Fact]
    public void Contacts_are_those_of_calculation_frames_where_there_are_any()
    {
        Broadcaster server = Serve(new BroadcasterOptions { Sources = [new SyntheticActor()], Calculation = CalculationSynthesizer.Write });
        MocapSource source = Add(server);
        Performer performer = WaitForPose(source);
        Loop.RunUntil(() => performer.HasMeasuredContacts && performer.Contacts != default);

        MocapSource estimated = Add(Serve(new SyntheticActor()));
        Performer other = WaitForPose(estimated);
        Loop.RunUntil(() => other.Contacts != default);
        Assert.False(other.HasMeasuredContacts);
    }

    [Fact]
    public void Contacts_arrive_over_a_calculation_port_of_TCP()
    {
        Broadcaster server = Serve(new BroadcasterOptions { Sources = [new SyntheticActor()], Calculation = CalculationSynthesizer.Write, CalculationPort = 0 });
        MocapSource source = Add(server, source => source.CalculationPort = server.CalculationEndPoint!.Port);
        Performer performer = WaitForPose(source);
        Loop.RunUntil(() => performer.HasMeasuredContacts && performer.Contacts != default);
        Loop.RunUntil(() => source.StatusMessage.Contains($"Calculation port {source.CalculationPort}: receiving.", StringComparison.Ordinal));
        Assert.Single(source.Performers);
    }

    [Fact]
    public void Contacts_arrive_over_a_calculation_port_of_UDP()
    {
        (int port, int calculationPort) = (FreeUdpPort(), FreeUdpPort());
        MocapSource source = Add(source => (source.Transport, source.Port, source.CalculationPort) = (TransportKind.Udp, port, calculationPort));
        Serve(new BroadcasterOptions
        {
            Sources = [new SyntheticActor()],
            UdpDestinations = [new IPEndPoint(IPAddress.Loopback, port)],
            Calculation = CalculationSynthesizer.Write,
            CalculationPort = calculationPort,
        });
        Performer performer = WaitForPose(source);
        Loop.RunUntil(() => performer.HasMeasuredContacts && performer.Contacts != default);
        Assert.Equal(0, performer.Sender);
    }

    [Fact]
    public void A_calculation_port_that_refuses_is_told_while_the_figure_moves()
    {
        int port = FreePort();
        MocapSource source = Add(Serve(new SyntheticActor()), source => source.CalculationPort = port);
        Performer performer = WaitForPose(source);
        Loop.RunUntil(() => source.StatusMessage.Contains($"Calculation port {port}: connection refused", StringComparison.Ordinal));
        Assert.Equal(SourceState.Receiving, source.State);
        Loop.RunUntil(() => performer.Contacts != default);
        Assert.False(performer.HasMeasuredContacts);
    }

    // The first server is gone for good, and its performer never.
    [Fact]
    public void A_performer_that_is_live_is_found_before_one_that_is_not()
    {
        int port = FreeUdpPort();
        MocapSource source = Add(source => (source.Transport, source.Port, source.GoneTimeout, source.IdleTimeout) = (TransportKind.Udp, port, 0, 0.1f));
        using System.Net.Sockets.UdpClient first = SenderFrom("127.0.0.11"), second = SenderFrom("127.0.0.12");
        var to = new IPEndPoint(IPAddress.Loopback, port);
        Performer? found = null;
        Loop.RunUntil(() => Send(first) && source.TryGetPerformer(0, out found) && found.IsLive);
        Assert.Equal(0, found!.Sender);
        Loop.RunUntil(() => Send(second) && source.TryGetPerformer(0, out found) && found.Sender == 1);
        Assert.True(source.TryGetPerformer("Char00", out found) && found.Sender == 1);
        Assert.Equal(2, source.Performers.Count);

        bool Send(System.Net.Sockets.UdpClient sender) => sender.Send(NeuronMocap.Tests.Network.TestPackets.Motion(1), to) > 0;
    }

    private static System.Net.Sockets.UdpClient SenderFrom(string address)
    {
        Assert.SkipUnless(OperatingSystem.IsLinux() || OperatingSystem.IsWindows(), "This system has one loopback address only.");
        return new System.Net.Sockets.UdpClient(new IPEndPoint(IPAddress.Parse(address), 0));
    }

    [Fact]
    public void In_a_browser_it_says_what_to_do_instead()
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
    public void A_script_that_adds_it_sets_it_before_it_opens()
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

    private static int FreeUdpPort()
    {
        using var socket = new System.Net.Sockets.UdpClient(new IPEndPoint(IPAddress.Loopback, 0));
        return ((IPEndPoint)socket.Client.LocalEndPoint!).Port;
    }
}
