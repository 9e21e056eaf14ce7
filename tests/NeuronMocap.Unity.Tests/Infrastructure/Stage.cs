using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Unity.Tests.Infrastructure;

/// <summary>Sources for tests: the built-in simulator, and a broadcaster over loopback with performers of given sizes.</summary>
internal static class Stage
{
    // Seconds without data until performers are idle. On a busy computer, the thread that sends can be late by a second.
    public const float Patience = 30;

    public static MocapSource AddSimulator(int performers = 1)
    {
        var holder = new GameObject("Simulator");
        holder.SetActive(false);
        var source = holder.AddComponent<MocapSource>();
        source.Kind = SourceKind.Simulator;
        source.PerformerCount = performers;
        source.IdleTimeout = Patience;
        holder.SetActive(true);
        return source;
    }

    public static MocapSource AddClient(Broadcaster server)
    {
        var holder = new GameObject("Client");
        holder.SetActive(false);
        var source = holder.AddComponent<MocapSource>();
        source.Kind = SourceKind.Network;
        source.Address = IPAddress.Loopback.ToString();
        source.Port = server.LocalEndPoint!.Port;
        source.IdleTimeout = Patience;
        holder.SetActive(true);
        return source;
    }

    public static Broadcaster Broadcast(params MotionSource[] sources)
    {
        var server = new Broadcaster(new BroadcasterOptions { Sources = sources, Port = 0 });
        server.Start();
        return server;
    }

    public static PerformerSpawner AddSpawner(MocapSource source)
    {
        var spawner = new GameObject("Spawner").AddComponent<PerformerSpawner>();
        spawner.Source = source;
        return spawner;
    }

    /// <summary>A computer that sends over UDP, as far as the receiver can tell.</summary>
    public static UdpClient SenderFrom(string address)
    {
        Assert.SkipUnless(OperatingSystem.IsLinux() || OperatingSystem.IsWindows(), "This system has one loopback address only.");
        return new UdpClient(new IPEndPoint(IPAddress.Parse(address), 0));
    }

    public static bool IsLive(MocapSource source, int performers = 1) =>
        source.Performers.Count == performers && source.Performers.All(static performer => performer.HasPose && performer.IsLive);
}

/// <summary>An actor who stands in the T-pose, in its current sizes.</summary>
internal sealed class StandingActor(SkeletonBody body) : MotionSource
{
    private volatile SkeletonBody _body = body;

    public SkeletonBody Body
    {
        get => _body;
        set => _body = value;
    }

    public override double FrameRate => 100;

    public override long? FrameCount => null;

    public override bool HasDisplacement => true;

    public override SkeletonVariant Variant => _body.Variant;

    public override void GetPose(long frame, Span<BoneTransform> pose) => _body.CopyRestPose(pose);

    public override FootContacts GetFootContacts(long frame) => new(true, true);
}
