using System.Net;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Sources;

// The data of a performer other than its pose: times, sizes and contacts.
public sealed class PerformerDataTests : SourceFixture
{
    [Theory]
    [InlineData(BroadcastFormat.Studio)]
    [InlineData(BroadcastFormat.Binary)]
    public void A_performer_has_the_timecode_of_its_newest_frame(BroadcastFormat format)
    {
        MocapSource source = Add(Serve(new BroadcasterOptions { Sources = [new SyntheticSource()], Format = format }));
        Performer performer = WaitForPose(source);
        if (format == BroadcastFormat.Studio)
            Loop.RunUntil(() => performer.Timecode is { Hours: < 24, Minutes: < 60, Seconds: < 60 });
        else
            Assert.Null(performer.Timecode);
    }

    [Fact]
    public void Frames_that_are_not_finite_are_skipped()
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
        Broadcaster server = Serve(new ValuesSource((_, layout, values) => values[layout.GetPositionIndex(Bone.LeftLeg) + 1] = -Volatile.Read(ref thigh)));
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
    public void Sizes_fall_back_to_the_command_channel()
    {
        var tall = SkeletonBody.FromDimensions(SkeletonBody.GetDefault().Measure() with { UpperLeg = 0.6f });
        Broadcaster server = Serve(new BroadcasterOptions { Sources = [new ValuesSource(static (_, _, _) => { }, tall)], IncludeDisplacement = false });
        using var commands = new CommandServer(server, new CommandServerOptions { Port = 0 });
        commands.Start();
        MocapSource without = Add(server);
        MocapSource with = Add(server, source => source.CommandPort = commands.LocalEndPoint!.Port);
        Performer performer = WaitForPose(with);

        // The answer usually comes after the first pose, and on a slow computer before it.
        Loop.RunUntil(() => Math.Abs(performer.Body.GetOffset(Bone.LeftLeg).Length() - 60) < 0.01f);

        // The pose is shown with a short delay.
        Loop.RunUntil(() => Math.Abs((performer.GetPosition(Bone.LeftLeg) - performer.GetPosition(Bone.LeftUpLeg)).magnitude - 0.6f) < 1e-4f);
        Assert.Same(SkeletonBody.GetDefault(), WaitForPose(without).Body);
    }

    [Fact]
    public void Contacts_prefer_calculation_frames()
    {
        Broadcaster server = Serve(new BroadcasterOptions { Sources = [new SyntheticSource()], Calculation = CalculationSynthesizer.Write });
        MocapSource source = Add(server);
        Performer performer = WaitForPose(source);
        Loop.RunUntil(() => performer.HasMeasuredContacts && performer.Contacts != default);

        MocapSource estimated = Add(Serve(new SyntheticSource()));
        Performer other = WaitForPose(estimated);
        Loop.RunUntil(() => other.Contacts != default);
        Assert.False(other.HasMeasuredContacts);
    }

    [Fact]
    public void Contacts_arrive_over_a_calculation_port_of_TCP()
    {
        Broadcaster server = Serve(new BroadcasterOptions { Sources = [new SyntheticSource()], Calculation = CalculationSynthesizer.Write, CalculationPort = 0 });
        MocapSource source = Add(server, source => source.CalculationPort = server.CalculationEndPoint!.Port);
        Performer performer = WaitForPose(source);
        Loop.RunUntil(() => performer.HasMeasuredContacts && performer.Contacts != default);
        Loop.RunUntil(() => source.StatusMessage.Contains($"Calculation port {source.CalculationPort}: receiving.", StringComparison.Ordinal));
        Assert.Single(source.Performers);
    }

    [Fact]
    public void Contacts_arrive_over_a_calculation_port_of_UDP()
    {
        (int port, int calculationPort) = (FreePort.Next(), FreePort.Next());
        MocapSource source = Add(source => (source.Transport, source.Port, source.CalculationPort) = (TransportKind.Udp, port, calculationPort));
        Serve(new BroadcasterOptions
        {
            Sources = [new SyntheticSource()],
            UdpDestinations = [new IPEndPoint(IPAddress.Loopback, port)],
            Calculation = CalculationSynthesizer.Write,
            CalculationPort = calculationPort,
        });
        Performer performer = WaitForPose(source);
        Loop.RunUntil(() => performer.HasMeasuredContacts && performer.Contacts != default);
        Assert.Equal(0, performer.Sender);
    }

    [Fact]
    public void A_refused_calculation_port_is_reported_while_the_figure_moves()
    {
        int port = FreePort.Next();
        MocapSource source = Add(Serve(new SyntheticSource()), source => source.CalculationPort = port);
        Performer performer = WaitForPose(source);
        Loop.RunUntil(() => source.StatusMessage.Contains($"Calculation port {port}: connection refused", StringComparison.Ordinal));
        Assert.Equal(SourceState.Receiving, source.State);
        Loop.RunUntil(() => performer.Contacts != default);
        Assert.False(performer.HasMeasuredContacts);
    }
}
