using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text;

namespace NeuronMocap.Server.Tests;

// Reads a stream of text to its end, line by line.
internal static class TextClient
{
    public static async Task<string> ReadToEndAsync(IPEndPoint? server)
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        await socket.ConnectAsync(server!, TestContext.Current.CancellationToken).AsTask().Soon();
        return await ReadToEndAsync(socket);
    }

    public static async Task<string> ReadToEndAsync(Socket socket)
    {
        using var bytes = new MemoryStream();
        byte[] buffer = new byte[64 * 1024];
        int read;
        while ((read = await socket.ReceiveAsync(buffer.AsMemory(), TestContext.Current.CancellationToken).Soon()) > 0)
            bytes.Write(buffer, 0, read);

        return Encoding.UTF8.GetString(bytes.ToArray());
    }

    // Returns a motion line's avatar, name and values.
    public static (int Avatar, string Name, double[] Values) ParseMotion(string line)
    {
        string[] parts = line.Split(' ');
        Assert.Equal("||", parts[^1]);
        return (int.Parse(parts[0], CultureInfo.InvariantCulture), parts[1], Parse(parts[2..^1]));
    }

    public static double[] ParseColumns(string line) => Parse(line.Split(' '));

    private static double[] Parse(string[] parts) => [.. parts.Select(part => double.Parse(part, CultureInfo.InvariantCulture))];
}
