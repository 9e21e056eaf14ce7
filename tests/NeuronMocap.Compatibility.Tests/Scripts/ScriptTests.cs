using System.Net;
using System.Net.Sockets;
using NeuronDataReaderWraper;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;
using UserScripts;

namespace NeuronMocap.Compatibility.Tests.Scripts;

// Programs as users wrote them, with the simulator: every frame arrives complete and with correct values.
public sealed class ScriptTests
{
    private const int Frames = 200;

    public static TheoryData<bool, bool, int?> Settings => new(
        from displacement in (bool[])[true, false]
        from reference in (bool[])[true, false]
        from fragment in (int?[])[null, 7, 1024]
        select (displacement, reference, fragment));

    [Theory, MemberData(nameof(Settings))]
    public async Task A_script_of_b15_receives_every_frame_of_two_avatars(bool displacement, bool reference, int? fragment)
    {
        BroadcasterOptions options = Options(displacement, reference, fragment, avatars: 2);
        options.Calculation = TestSource.WriteCalculation;
        using var server = new Broadcaster(options);
        server.Start();
        try
        {
            W2Script.Init(new IntPtr(5), new IntPtr(6));
            IntPtr connection = W2Script.Connect("127.0.0.1", server.LocalEndPoint!.Port);
            await Limits.UntilAsync(static () => W2Script.Count(W2Script.CalculationFrames) == 2 * Frames);

            AssertFrames(options, [.. W2Script.Frames], connection, customObject: 5);
            Assert.All(W2Script.Frames, static frame => Assert.Equal("1.1.0.0", frame.Version));
            Assert.Equal(
                Enumerable.Range(0, 2 * Frames).Select(static i => (i % 2, (uint)(i / 2), 946, 6L)),
                W2Script.CalculationFrames.Select(static frame => (frame.Avatar, frame.FrameIndex, frame.Values.Length, frame.CustomObject)));
            await Limits.UntilAsync(() => !W2Script.IsRunning(connection));
        }
        finally
        {
            W2Script.CloseAll();
        }
    }

    [Fact]
    public async Task A_script_of_b15_receives_the_old_header_with_an_index_that_counts()
    {
        BroadcasterOptions options = Options(displacement: true, reference: false, fragment: 7, avatars: 2);
        options.DataVersion = NeuronMocap.DataVersion.Old;
        using var server = new Broadcaster(options);
        server.Start();
        try
        {
            W2Script.Init(new IntPtr(5), new IntPtr(6));
            IntPtr connection = W2Script.Connect("localhost", server.LocalEndPoint!.Port);
            await Limits.UntilAsync(static () => W2Script.Count(W2Script.Frames) == 2 * Frames);
            AssertFrames(options, [.. W2Script.Frames], connection, customObject: 5);
        }
        finally
        {
            W2Script.CloseAll();
        }
    }

    [Fact]
    public async Task A_script_of_b15_receives_text()
    {
        BroadcasterOptions options = Options(displacement: true, reference: true, fragment: 1024, avatars: 1);
        options.Sources = [new Server.SyntheticSource()];
        options.MaxFrames = Frames;
        options.Format = BroadcastFormat.Text;
        using var server = new Broadcaster(options);
        server.Start();
        try
        {
            W2Script.Init(IntPtr.Zero, IntPtr.Zero);
            W2Script.Connect("127.0.0.1", server.LocalEndPoint!.Port);
            await Limits.UntilAsync(static () => W2Script.Count(W2Script.Frames) == Frames);

            Assert.Equal(Enumerable.Range(0, Frames).Select(static i => (uint)i), W2Script.Frames.Select(static frame => frame.FrameIndex));
            foreach (ReceivedFrame frame in W2Script.Frames)
            {
                float[] expected = new float[360];
                options.Sources[0].WriteValues(frame.FrameIndex, new ChannelLayout(true, true), options.RotationOrder, expected);
                Assert.Equal(("Char00", "1.1.0.0", 360), (frame.AvatarName, frame.Version, frame.Values.Length));
                Assert.All(expected.Zip(frame.Values), static pair => Assert.Equal(pair.First, pair.Second, 0.01f));
            }
        }
        finally
        {
            W2Script.CloseAll();
        }
    }

    [Fact]
    public async Task A_script_of_b15_listens_to_datagrams_from_macOS()
    {
        // All datagrams at once fit into the smallest buffer that a system grants.
        const int Few = 50;
        int port = FreePort.Next();
        BroadcasterOptions options = Options(displacement: true, reference: false, fragment: 1024, avatars: 1);
        options.MaxFrames = Few;
        options.Port = null;
        options.FrameRate = 1000;
        options.UdpDestinations = [new IPEndPoint(IPAddress.Loopback, port)];
        try
        {
            W2Script.Init(new IntPtr(5), IntPtr.Zero);
            IntPtr service = W2Script.Listen(port);
            using var server = new Broadcaster(options);
            server.Start();
            await Limits.UntilAsync(static () => W2Script.Count(W2Script.Frames) == Few);
            AssertFrames(options, [.. W2Script.Frames], service, customObject: 5, Few);
        }
        finally
        {
            W2Script.CloseAll();
        }
    }

    [Fact]
    public async Task A_script_of_b12_receives_every_frame_and_reconnects()
    {
        BroadcasterOptions options = Options(displacement: true, reference: false, fragment: null, avatars: 1);
        options.DataVersion = NeuronMocap.DataVersion.Old;
        using var server = new Broadcaster(options);
        server.Start();
        string port = server.LocalEndPoint!.Port.ToString(System.Globalization.CultureInfo.InvariantCulture);
        var script = new W1Script();
        try
        {
            Assert.True(script.Connect("127.0.0.1", port));
            IntPtr first = script.Socket;
            await Limits.UntilAsync(() => script.FramesOf(first).Length == Frames);
            Assert.All(script.FramesOf(first), static frame => Assert.Equal((71L, "Char00", 354, true, false),
                (frame.CustomObject, frame.AvatarName, frame.Values.Length, frame.WithDisplacement, frame.WithReference)));
            await Limits.UntilAsync(() => script.Lines().Length == 4);
            Assert.Equal(["0 Failed to read data.", "0 Data thread exited.\n"], script.Lines()[2..]);
        }
        finally
        {
            script.Close();
        }
    }

    // Servers of that generation answer on the data connection.
    [Fact]
    public async Task A_script_of_b12_gets_answers_to_its_commands_between_frames()
    {
        using var server = new TestServer();
        var script = new W1Script();
        try
        {
            Assert.True(script.Connect("127.0.0.1", server.Port.ToString(System.Globalization.CultureInfo.InvariantCulture)));
            using TestConnection connection = await server.AcceptAsync();
            Assert.True(script.AskForEverything(3));

            // Commands 0, 3, 6 and 4 of avatar 3; commands 7 and 8 about command 6; command 5.
            byte[] requests = new byte[7 * 64];
            for (int read = 0; read < requests.Length;)
                read += await connection.Socket.ReceiveAsync(requests.AsMemory(read), SocketFlags.None, TestContext.Current.CancellationToken).Soon();
            Assert.Equal(
                ["FFAA 0 3", "FFAA 3 3", "FFAA 6 3", "FFAA 4 3", "FFAA 7 6", "FFAA 8 6", "FFAA 5 0"],
                requests.Chunk(64).Select(static request =>
                    $"{Convert.ToHexString(request, 0, 2)} {BitConverter.ToInt32(request, 14)} {BitConverter.ToInt32(request, 18)}"));

            await connection.SendPiecesAsync(
                TestPackets.Join(
                    DataReplies.BoneSizes(("Hips", 0.5f), ("RightUpLeg", 0.25f)),
                    TestPackets.Motion(1),
                    DataReplies.Frequency(3, 120),
                    DataReplies.CombinationMode(3, 2),
                    DataReplies.BvhText("HIERARCHY\n"),
                    TestPackets.Motion(2),
                    DataReplies.AvatarCount(4),
                    TestPackets.Motion(3)),
                size: 13);
            await Limits.UntilAsync(() => script.FramesOf(script.Socket).Length == 3);

            Assert.Equal([("Hips", 0.5f), ("RightUpLeg", 0.25f)], script.BoneSizes.Select(static bone => (bone.BoneName, bone.BoneLength)));
            Assert.Equal("HIERARCHY\n", script.BvhText);
            Assert.Equal([3, 120], script.NumbersOf(CmdId.Cmd_DataFrequency));
            Assert.Equal([3, 2], script.NumbersOf(CmdId.Cmd_CombinationMode));
            Assert.Equal(4, script.NumbersOf(CmdId.Cmd_AvatarCount)[0]);
        }
        finally
        {
            script.Close();
        }
    }

    [Fact]
    public async Task A_script_of_b12_gets_answers_from_the_simulator()
    {
        BroadcasterOptions options = Options(displacement: true, reference: false, fragment: null, avatars: 1);
        options.Sources = [new Server.SyntheticSource()];
        options.FrameRate = 60;
        options.MaxFrames = null;
        using var server = new Broadcaster(options);
        server.Start();
        var script = new W1Script();
        try
        {
            Assert.True(script.Connect("127.0.0.1", server.LocalEndPoint!.Port.ToString(System.Globalization.CultureInfo.InvariantCulture)));
            Assert.True(script.AskForEverything(0));
            await Limits.UntilAsync(() => script.NumbersOf(CmdId.Cmd_AvatarCount) is not null);

            Assert.Equal(1, script.NumbersOf(CmdId.Cmd_AvatarCount)[0]);
            Assert.Equal([0, 60], script.NumbersOf(CmdId.Cmd_DataFrequency));
            Assert.Contains(script.BoneSizes, static bone => bone.BoneName == "RightLeg");
            Assert.StartsWith("HIERARCHY", script.BvhText, StringComparison.Ordinal);
        }
        finally
        {
            script.Close();
        }
    }

    // The way programs use the C functions of b18: a stream, and a second connection for commands.
    [Fact]
    public async Task A_script_with_a_command_connection_turns_the_simulators_actor()
    {
        BroadcasterOptions options = Options(displacement: true, reference: false, fragment: null, avatars: 1);
        options.Sources = [new Server.SyntheticSource()];
        options.FrameRate = 240;
        options.RotationOrder = RotationOrder.XYZ;
        using var server = new Broadcaster(options);
        using var commands = new CommandServer(server, new CommandServerOptions { Port = 0 });
        server.Start();
        commands.Start();
        try
        {
            W2Script.Init(IntPtr.Zero, IntPtr.Zero);
            W2Script.Connect("127.0.0.1", server.LocalEndPoint!.Port);
            IntPtr pipe = NeuronDataReader.BRConnectCmd("127.0.0.1", commands.LocalEndPoint!.Port);
            await Limits.UntilAsync(static () => W2Script.Count(W2Script.Frames) > 0);

            Assert.True(NeuronDataReader.GetBvhRotation(pipe, out RotateOrders order));
            Assert.Equal(RotateOrders.RO_XYZ, order);
            Assert.True(NeuronDataReader.GetBoneSize(pipe, 0, out BoneDimension sizes));
            Assert.InRange(sizes.UpperLeg, 0.3f, 0.6f);
            var header = new System.Text.StringBuilder();
            Assert.True(NeuronDataReader.GetBvhHeader(pipe, 0, header, 100_000));
            Assert.StartsWith("HIERARCHY", header.ToString(), StringComparison.Ordinal);
            Assert.True(NeuronDataReader.ZeroOut(pipe, 0));
            Assert.False(NeuronDataReader.ZeroOut(pipe, 1));
            Assert.True(NeuronDataReader.ZeroOutAll(pipe));
            NeuronDataReader.BRCloseSocket(pipe);
        }
        finally
        {
            W2Script.CloseAll();
        }
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_script_of_the_managed_reader_keeps_the_newest_frame_of_each_actor(bool udp)
    {
        int port = FreePort.Next();
        BroadcasterOptions options = Options(displacement: false, reference: false, fragment: null, avatars: 3);
        options.FrameRate = 240;
        options.Sources = [.. Enumerable.Range(0, 3).Select(static avatar => new TestSource(avatar))];
        options.Port = udp ? null : 0;
        options.UdpDestinations = udp ? [new IPEndPoint(IPAddress.Loopback, port)] : [];
        using var server = new Broadcaster(options);
        server.Start();
        ManagedScript? script = ManagedScript.Connect("127.0.0.1", udp ? port : server.LocalEndPoint!.Port, commandServerPort: 0, udp);
        Assert.NotNull(script);
        Assert.True(ManagedScript.Supports(script));

        await Limits.UntilAsync(() => script.GetData(0) is not null && script.GetData(1) is not null && script.GetData(2) is not null && script.FrameCount > 60);

        Assert.Equal(180, script.GetData(2).Length);
        script.Disconnect();
        int count = script.FrameCount;
        Assert.Null(NeuronDataReaderManaged.NeuronDataReader.frameDataReceivedCallback);
        Assert.Null(NeuronDataReaderManaged.NeuronDataReader.socketStatusChangedCallback);
        Assert.Equal(count, script.FrameCount);
        if (!udp)
            Assert.Equal("Service is stoped\n", script.Message);
    }

    private static BroadcasterOptions Options(bool displacement, bool reference, int? fragment, int avatars) => new()
    {
        Sources = [.. Enumerable.Range(0, avatars).Select(static avatar => new TestSource(avatar, Frames))],
        Port = 0,
        FrameRate = BroadcasterOptions.MaxFrameRate,
        IncludeDisplacement = displacement,
        IncludeReference = reference,
        Fragment = fragment,
    };

    private static void AssertFrames(BroadcasterOptions options, ReceivedFrame[] frames, IntPtr connection, long customObject, int count = Frames)
    {
        var layout = new ChannelLayout(options.IncludeDisplacement!.Value, options.IncludeReference);
        int avatars = options.Sources.Count;
        float[] expected = new float[layout.ValueCount];
        Assert.Equal(count * avatars, frames.Length);
        foreach ((ReceivedFrame frame, int i) in frames.Select(static (frame, i) => (frame, i)))
        {
            Assert.Equal(
                (connection, customObject, i % avatars, $"Char{i % avatars:00}", (uint)(i / avatars), layout.HasDisplacement, layout.HasReference),
                (frame.Connection, frame.CustomObject, frame.Avatar, frame.AvatarName, frame.FrameIndex, frame.WithDisplacement, frame.WithReference));
            options.Sources[frame.Avatar].WriteValues(frame.FrameIndex, layout, options.RotationOrder, expected);
            Assert.True(System.Runtime.InteropServices.MemoryMarshal.AsBytes<float>(expected)
                .SequenceEqual(System.Runtime.InteropServices.MemoryMarshal.AsBytes<float>(frame.Values)));
        }
    }
}
