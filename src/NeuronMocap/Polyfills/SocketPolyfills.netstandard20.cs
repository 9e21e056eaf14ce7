using System.Buffers;
using System.Net.Sockets;
using System.Runtime.InteropServices;

namespace NeuronMocap.Polyfills;

// Members of sockets that netstandard2.0 lacks.
internal static class SocketPolyfills
{
    // Through a rented array.
    public static int Send(this Socket socket, ReadOnlySpan<byte> source, SocketFlags flags, out SocketError error)
    {
        byte[] bytes = ArrayPool<byte>.Shared.Rent(source.Length);
        try
        {
            source.CopyTo(bytes);
            return socket.Send(bytes, 0, source.Length, flags, out error);
        }
        finally
        {
            ArrayPool<byte>.Shared.Return(bytes);
        }
    }

    // The memory belongs to an array.
    public static Task<int> ReceiveAsync(this Socket socket, Memory<byte> destination, SocketFlags flags)
    {
        _ = MemoryMarshal.TryGetArray(destination, out ArraySegment<byte> bytes);
        return Task.Factory.FromAsync(
            (callback, state) => socket.BeginReceive(bytes.Array!, bytes.Offset, bytes.Count, flags, callback, state), socket.EndReceive, state: null);
    }
}
