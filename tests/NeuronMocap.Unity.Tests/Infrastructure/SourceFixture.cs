using System.Diagnostics;
using NeuronMocap.Server;

namespace NeuronMocap.Unity.Tests.Infrastructure;

/// <summary>A scene and servers for it. At the end, it asserts that nothing is left running.</summary>
public abstract class SourceFixture : IDisposable
{
    /// <summary>In milliseconds.</summary>
    internal const double Quick = 100;

    private readonly List<Broadcaster> _servers = [];

    internal PlayerLoop Loop { get; private protected set; } = new();

    public virtual void Dispose()
    {
        Loop.Dispose();
        Assert.Equal(0, SourceConnections.Count);
        Assert.Empty(MocapSource.All);

        // Ends when receive threads, playbacks and broadcasters have ended.
        Assert.True(SourceConnections.Closed.Wait(Limits.Unexpected));
        foreach (Broadcaster server in _servers)
            server.Dispose();

        GC.SuppressFinalize(this);
    }

    internal Broadcaster Serve(params MotionSource[] performers) => Serve(new BroadcasterOptions { Sources = performers });

    internal Broadcaster Serve(BroadcasterOptions options)
    {
        options.Port ??= 0;
        if (options.Port == NeuronMocap.Protocol.ProtocolConstants.DefaultPort)
            options.Port = 0;

        var server = new Broadcaster(options);
        server.Start();
        _servers.Add(server);
        return server;
    }

    internal static MocapSource Add(Broadcaster server, Action<MocapSource>? set = null) =>
        Add(source =>
        {
            source.Port = server.LocalEndPoint!.Port;
            set?.Invoke(source);
        });

    internal static MocapSource Add(Action<MocapSource> set)
    {
        MocapSource source = new GameObject("Source").AddComponent<MocapSource>();
        source.IdleTimeout = Stage.Patience;
        set(source);
        return source;
    }

    internal static MocapSource AddSimulator(int performers = 1, SimulatedMotion motion = SimulatedMotion.WalkAndGestures) => Add(source =>
    {
        source.Kind = SourceKind.Simulator;
        source.PerformerCount = performers;
        source.Motion = motion;
    });

    internal Performer WaitForPose(MocapSource source, int performer = 0)
    {
        Performer? found = null;
        Loop.RunUntil(() => source.TryGetPerformer(performer, out found) && found.HasPose);
        return found!;
    }

    /// <summary>
    /// Closing must not be noticeable in a game. It takes some milliseconds. A wait for a time-out takes 2 s or more in each attempt, while a busy
    /// machine only delays single attempts.
    /// </summary>
    internal static void AssertQuick(Func<double> close)
    {
        const int Tries = 20;
        double quickest = double.PositiveInfinity;
        for (int i = 0; i < Tries && quickest > Quick; i++)
            quickest = Math.Min(quickest, close());

        Assert.InRange(quickest, 0, Quick);
    }

    /// <returns>The time in milliseconds.</returns>
    internal static double Measure(Action action)
    {
        var watch = Stopwatch.StartNew();
        action();
        return watch.Elapsed.TotalMilliseconds;
    }
}
