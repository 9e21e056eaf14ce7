using System.Net;
using System.Net.Sockets;
using System.Runtime.InteropServices;

namespace NeuronMocap;

internal sealed class TcpListener(IPAddress address, int port) : System.Net.Sockets.TcpListener(address, port), IDisposable
{
    // A cancelled accept goes on until the listener stops. What it still accepts is closed.
    public async ValueTask<Socket> AcceptSocketAsync(CancellationToken cancellationToken)
    {
        Task<Socket> accepting = AcceptSocketAsync();
        try
        {
            return await accepting.WaitAsync(cancellationToken);
        }
        catch (OperationCanceledException)
        {
            _ = accepting.ContinueWith(static accepted => accepted.Result.Dispose(), CancellationToken.None, TaskContinuationOptions.OnlyOnRanToCompletion, TaskScheduler.Default);
            throw;
        }
    }

    // Stop closes the socket and creates another one for the next start. Without this, that one stays open until it is finalized.
    public void Dispose()
    {
        Stop();
        Server.Dispose();
    }
}

internal static class Sockets
{
    public static bool Poll(this Socket socket, TimeSpan time, SelectMode mode) => socket.Poll((int)(time.TotalMilliseconds * 1000), mode);

    // Mono sends an empty datagram only to a given address.
    public static int Send(this Socket socket, ReadOnlySpan<byte> bytes) =>
        bytes.IsEmpty ? socket.SendTo([], socket.RemoteEndPoint!) : socket.Send(bytes.ToArray());

    public static ValueTask<int> SendAsync(this Socket socket, ReadOnlyMemory<byte> bytes, SocketFlags flags, CancellationToken cancellationToken = default) =>
        new(SocketTaskExtensions.SendAsync(socket, Segment(bytes), flags).WaitAsync(cancellationToken));

    public static ValueTask<int> ReceiveAsync(this Socket socket, Memory<byte> bytes, CancellationToken cancellationToken) =>
        socket.ReceiveAsync(bytes, SocketFlags.None, cancellationToken);

    public static ValueTask<int> ReceiveAsync(this Socket socket, Memory<byte> bytes, SocketFlags flags, CancellationToken cancellationToken = default) =>
        new(SocketTaskExtensions.ReceiveAsync(socket, Segment(bytes), flags).WaitAsync(cancellationToken));

    private static ArraySegment<byte> Segment(ReadOnlyMemory<byte> bytes) =>
        MemoryMarshal.TryGetArray(bytes, out ArraySegment<byte> segment) ? segment : throw new NotSupportedException();
}
