using System.Net;

namespace NeuronMocap.Server;

/// <content>A server for trying things out.</content>
public sealed partial class Broadcaster
{
    /// <summary>Starts a server that needs no suit and no file.</summary>
    /// <remarks>
    /// The server sends <see cref="SyntheticSource"/>s on a free TCP port of this computer. Read the port from <see cref="LocalEndPoint"/>.
    /// It sends the first frame when the first client has connected.
    /// <para>
    /// The server answers data commands on that port. To open its command channel, create a <see cref="CommandServer"/>:
    /// <c>new CommandServer(demo, new CommandServerOptions { Port = 0 })</c>.
    /// </para>
    /// </remarks>
    /// <param name="avatars">Number of avatars, 1 to 256. Each walks its own ring.</param>
    /// <param name="frameRate">Frames per second, 0.01 to 100,000.</param>
    /// <param name="rotationOrder">Order of the rotation values, one of the six.</param>
    /// <returns>A broadcaster that runs until it is disposed.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of range.</exception>
    /// <exception cref="BroadcasterException">The system has no free port.</exception>
    public static Broadcaster StartDemo(int avatars = 1, double frameRate = 60, RotationOrder rotationOrder = RotationOrder.YXZ)
    {
        if (avatars is < 1 or > 256)
            throw new ArgumentOutOfRangeException(nameof(avatars), avatars, "The number of avatars must be 1 to 256.");
        if (frameRate is not (>= 0.01 and <= 100_000))
            throw new ArgumentOutOfRangeException(nameof(frameRate), frameRate, "The frame rate must be 0.01 to 100,000 Hz.");
        if (rotationOrder is < RotationOrder.XZY or > RotationOrder.ZYX)
            throw new ArgumentOutOfRangeException(nameof(rotationOrder), rotationOrder, "The rotation order must be one of the six orders.");

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
