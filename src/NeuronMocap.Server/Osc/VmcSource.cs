using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Osc;
using NeuronMocap.Transport;

namespace NeuronMocap.Server;

/// <summary>
/// Receives the poses of a program that sends the Virtual Motion Capture protocol (VMC), such as VirtualMotionCapture, VSeeFace or another
/// <see cref="VmcSender"/>. A reader then delivers them as motion frames: set <see cref="NeuronReaderOptions.Source"/>.
/// </summary>
/// <remarks>
/// <para>
/// A port takes one performer. Frames have displacement: the lengths of the sender's model. Bones of the stream that VMC lacks do not turn. Expressions and
/// trackers are ignored.
/// </para>
/// <para>Any bytes may arrive. Those that are not OSC, and values that are not finite, are counted in <see cref="Rejected"/>.</para>
/// </remarks>
public sealed class VmcSource : ByteSource
{
    private readonly IPEndPoint _endPoint;
    private readonly AvatarName _avatarName;
    private long _rejected;
    private IPEndPoint? _localEndPoint;

    /// <summary>Creates a source. The reader opens the port.</summary>
    /// <param name="port">UDP port of this computer, 0 to 65535; 0 takes any free port. Default: 39539, the usual port of VMC receivers.</param>
    /// <param name="address">Address of this computer to receive on; null for all IPv4 addresses.</param>
    /// <param name="avatarName">Name of the avatar in the frames; text beyond 32 bytes of UTF-8 is cut off.</param>
    /// <exception cref="ArgumentOutOfRangeException">The port is out of range.</exception>
    public VmcSource(int port = 39539, IPAddress? address = null, string avatarName = "VMC")
    {
        if (port is < 0 or > IPEndPoint.MaxPort)
            throw new ArgumentOutOfRangeException(nameof(port), port, "The port must be 0 to 65535.");

        _endPoint = new IPEndPoint(address ?? IPAddress.Any, port);
        Name = IsAny ? $"VMC port {port}" : $"VMC port {port} of {_endPoint.Address}";
        _avatarName = new AvatarName(avatarName);
    }

    /// <summary>Gets the name for status messages, such as "VMC port 39539", or "VMC port 39539 of 192.168.1.5" if an address is given.</summary>
    public override string Name { get; }

    /// <summary>Address and real port; null until the reader has opened the port. Thread-safe.</summary>
    public IPEndPoint? LocalEndPoint => Volatile.Read(ref _localEndPoint);

    /// <summary>Number of datagrams that are not OSC, and of transforms with values that cannot be. Thread-safe.</summary>
    public long Rejected => Interlocked.Read(ref _rejected);

    internal override long RejectedMessages => Rejected;

    /// <summary>Opens the port. The reader calls this method.</summary>
    /// <param name="cancellationToken">Not used, because a port opens at once.</param>
    /// <returns>A stream of motion packets. A read waits until a frame has arrived.</returns>
    /// <exception cref="NeuronConnectionException">The address is not one of this computer.</exception>
    /// <exception cref="SocketException">The port is in use, or the system does not allow it.</exception>
    public override ValueTask<Stream> OpenAsync(CancellationToken cancellationToken)
    {
        var socket = new Socket(_endPoint.AddressFamily, SocketType.Dgram, ProtocolType.Udp);
        try
        {
            Bind(socket);
            Volatile.Write(ref _localEndPoint, (IPEndPoint)socket.LocalEndPoint!);
            return new ValueTask<Stream>(new VmcStream(socket, new VmcDecoder(_avatarName), rejected => Interlocked.Add(ref _rejected, rejected)));
        }
        catch
        {
            socket.Dispose();
            throw;
        }
    }

    // A thread of its own: the stream waits in blocking reads.
    internal override async ValueTask<ByteReceiver> OpenReceiverAsync(ReceiveThread wanted, CancellationToken cancellationToken) =>
        new BlockingStreamReceiver(await OpenAsync(cancellationToken).ConfigureAwait(false), leaveOpen: false);

    private bool IsAny => _endPoint.Address.Equals(IPAddress.Any) || _endPoint.Address.Equals(IPAddress.IPv6Any);

    private void Bind(Socket socket)
    {
        try
        {
            socket.Bind(_endPoint);
        }
        catch (SocketException exception) when (exception.SocketErrorCode == SocketError.AddressNotAvailable)
        {
            throw new NeuronConnectionException(
                ConnectionReason.AddressUnavailable,
                $"{_endPoint.Address} is not an address of this computer. A source receives on one of this computer's own addresses: choose one, or none to receive on all.");
        }
    }
}
