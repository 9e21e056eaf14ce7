using System.Net;
using System.Net.Sockets;
using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// Identifies a server that accepts connections but sends nothing. It sends two requests, because many servers only answer.
internal static class ServerProbe
{
    // The command that reads the rotation order, number 1003 (protocol.md sections 2.5 and 6). It changes nothing.
    private static readonly byte[] RotationCommand =
        [0xFF, 0xAA, 0, 0, 0xEB, 0x03, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xBB];

    private static readonly byte[] WebRequest = Encoding.ASCII.GetBytes("HEAD / HTTP/1.0\r\n\r\n");

    // Returns the server's answer; null if there is no answer.
    public static async Task<StreamSample?> AskAsync(DiagnosisContext context, IPAddress address)
    {
        var server = new IPEndPoint(address, context.Link.Port);
        TimeSpan time = context.Share(context.Budget.Asking);
        byte[][] answers = await Task.WhenAll(
            ExchangeAsync(server, RotationCommand, time, context.CancellationToken),
            ExchangeAsync(server, WebRequest, time, context.CancellationToken)).ConfigureAwait(false);
        context.CancellationToken.ThrowIfCancellationRequested();

        // A web server answers both requests; its answer to the command is an error page.
        byte[]? answer = answers.LastOrDefault(static bytes => bytes.Length > 0);
        if (answer is null)
            return null;

        var sample = new StreamSample(context.Expected);
        sample.OnSkipped(answer, SkipReason.NoTokens);
        return sample;
    }

    private static async Task<byte[]> ExchangeAsync(IPEndPoint server, byte[] question, TimeSpan time, CancellationToken cancellationToken)
    {
        byte[] answer = new byte[256];
        int length = 0;
        using var limitSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken);
        limitSource.CancelAfter(time);
        using var socket = new Socket(server.AddressFamily, SocketType.Stream, ProtocolType.Tcp);
        using CancellationTokenRegistration closing = limitSource.Token.Register(socket.Dispose);
        try
        {
            await socket.ConnectAsync(server).ConfigureAwait(false);
            await socket.SendAsync(new ArraySegment<byte>(question), SocketFlags.None).ConfigureAwait(false);
            int count = 1;

            // This many bytes are enough to identify the answer. Most servers then wait for the next request, so a wait for more bytes would take all the
            // time.
            while (count > 0 && length < question.Length)
            {
                var room = new ArraySegment<byte>(answer, length, answer.Length - length);
                count = await socket.ReceiveAsync(room, SocketFlags.None).ConfigureAwait(false);
                length += count;
            }
        }
        catch (Exception exception) when (SocketErrors.IsExpected(exception))
        {
            // The bytes before the error are the answer.
        }

        return answer.AsSpan(0, length).ToArray();
    }
}
