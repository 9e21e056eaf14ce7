using System.Net;

namespace NeuronMocap.Server;

/// <content>A server for trying things out.</content>
public sealed partial class Broadcaster
{
    /// <summary>
    /// Starts a server that needs no suit and no file: <see cref="SyntheticSource"/>s on a free TCP port of this computer, which
    /// <see cref="LocalEndPoint"/> tells. The first frame is sent when the first client has connected.
    /// <para>
    /// It answers data commands on that port. A <see cref="CommandServer"/> opens its command channel:
    /// <c>new CommandServer(demo, new CommandServerOptions { Port = 0 })</c>.
    /// </para>
    /// </summary>
    /// <param name="avatars">Number of actors, 1 to 256; each walks a ring of its own.</param>
    /// <param name="frameRate">Frames per second.</param>
    /// <param name="rotationOrder">Order of the rotation values.</param>
    /// <returns>A broadcaster that runs until it is disposed of.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
    /// <exception cref="BroadcasterException">The system has no free port.</exception>
    public static Broadcaster StartDemo(int avatars = 1, double frameRate = 60, RotationOrder rotationOrder = RotationOrder.YXZ)
    {
        if (avatars is < 1 or > 256)
            throw new ArgumentOutOfRangeException(nameof(avatars), avatars, "A demo has 1 to 256 avatars.");

        var demo = new Broadcaster(new BroadcasterOptions
        {
            Sources = [.. Enumerable.Range(0, avatars).Select(avatar => new SyntheticSource(frameRate, avatar))],
            AvatarNames = [.. Enumerable.Range(1, avatars).Select(number => avatars == 1 ? "Demo" : FormattableString.Invariant($"Demo {number}"))],
            BindAddress = IPAddress.Loopback,
            Port = 0,
            WaitForClient = true,
            RotationOrder = rotationOrder,
        });
        try
        {
            demo.Start();
            return demo;
        }
        catch
        {
            demo.Dispose();
            throw;
        }
    }
}
