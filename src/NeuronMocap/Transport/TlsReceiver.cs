using System.Diagnostics;
using System.Net;
using System.Net.Security;
using System.Net.Sockets;
using System.Security.Authentication;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// A TCP connection whose bytes are encrypted. It has its own thread on every target: blocking reads allocate nothing, and closing the socket ends the
// handshake and every read.
internal sealed class TlsReceiver(LinkOptions options, NeuronTlsOptions tls) : TcpReceiver
{
    // TLS never gives more at once.
    private const int LargestRecord = 16 * 1024;

    private SslStream? _stream;

    public override ReceiveThread Thread => ReceiveThread.Dedicated;

    public override Task ConnectAsync(Socket socket, IPEndPoint remote) =>
        DedicatedThread.RunAsync("NeuronMocap TLS connect", () => Connect(socket, remote), TaskCreationOptions.None);

    public override Task ReceiveAsync(Socket socket, PacketAssembler assembler) =>
        DedicatedThread.RunAsync("NeuronMocap TLS receive", () => Receive(assembler), TaskCreationOptions.None);

    public override bool TrySend(Socket socket, ReadOnlySpan<byte> bytes)
    {
        try
        {
            _stream!.Write(bytes.ToArray(), 0, bytes.Length);
            return true;
        }
        catch (IOException)
        {
            return false;
        }
    }

    // The thread that reads disposes the stream.
    public override void Close()
    {
    }

    private void Connect(Socket socket, IPEndPoint remote)
    {
        TcpConnect.Run(socket, remote);

        // A handshake of a socket with itself would fail for a reason that misleads.
        if (TcpLink.IsOwnEcho(socket, remote))
            return;

        var check = new CertificateCheck(options.Target, tls);
        var stream = new SslStream(new NetworkStream(socket, ownsSocket: false), leaveInnerStreamOpen: false, check.Accepts);
        try
        {
            stream.AuthenticateAsClient(tls.TargetHost ?? options.Host, clientCertificates: null, SslProtocols.None, checkCertificateRevocation: false);
            _stream = stream;
        }
        catch (Exception exception)
        {
            stream.Dispose();
            if (check.Fault is { } fault)
                throw new NeuronConnectionException(ConnectionReason.CertificateRejected, fault);
            if (exception is AuthenticationException or IOException { InnerException: not SocketException })
                throw new NeuronConnectionException(ConnectionReason.TlsFailed, ConnectionMessages.TlsFailed(options.Target, exception));

            throw AsSocketException(exception) ?? exception;
        }
    }

    private void Receive(PacketAssembler assembler)
    {
        using SslStream stream = _stream!;
        byte[] buffer = new byte[LargestRecord];
        while (Read(stream, buffer) is > 0 and var count)
            assembler.Push(new ArraySegment<byte>(buffer, 0, count), Stopwatch.GetTimestamp());
    }

    // A connection that ends without a word of TLS, or with bytes that are not TLS, counts as reset: somebody may have cut it.
    private static int Read(SslStream stream, byte[] buffer)
    {
        try
        {
            return stream.Read(buffer, 0, buffer.Length);
        }
        catch (IOException exception)
        {
            throw AsSocketException(exception) ?? new SocketException((int)SocketError.ConnectionReset);
        }
    }

    private static SocketException? AsSocketException(Exception exception) =>
        exception is IOException { InnerException: SocketException inner } ? new SocketException((int)inner.SocketErrorCode) : null;
}
