using System.Buffers.Binary;
using System.Collections.Concurrent;
using System.Net.Sockets;
using NeuronMocap.Commands;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Commands;

// A command server that answers every request as a test says, on any number of connections.
internal sealed class CommandScript : IDisposable
{
    private readonly TestServer _server = new();
    private readonly CancellationTokenSource _end = new();
    private readonly Func<ScriptedRequest, Task> _answer;
    private readonly ConcurrentQueue<TestConnection> _connections = [];
    private int _requests;

    public CommandScript(Func<ScriptedRequest, Task> answer, Func<TestConnection, Task>? greet = null)
    {
        _answer = answer;
        _ = AcceptAllAsync(greet ?? (static _ => Task.CompletedTask));
    }

    public int Port => _server.Port;

    public int Connections => _connections.Count;

    public int Requests => Volatile.Read(ref _requests);

    public static CommandScript Always(byte[] payload) => new(request => request.ReplyAsync(payload));

    // Gives each answer once, then repeats the last one.
    public static CommandScript InTurn(params Func<ScriptedRequest, Task>[] answers) =>
        new(request => answers[Math.Min(request.Number, answers.Length - 1)](request));

    public static byte[] Packet(byte[] payload, int id, int? size = null)
    {
        byte[] packet = new byte[CommandChannelHeader.Size + payload.Length];
        new CommandChannelHeader { CommandId = (ushort)id, PayloadSize = size ?? payload.Length }.Write(packet);
        payload.CopyTo(packet, CommandChannelHeader.Size);
        return packet;
    }

    public NeuronCommandClient CreateClient(Action<NeuronCommandOptions>? change = null)
    {
        var options = new NeuronCommandOptions { Port = Port, Timeout = Limits.Unexpected, ConnectTimeout = Limits.Unexpected };
        change?.Invoke(options);
        return new NeuronCommandClient(options);
    }

    public void Dispose()
    {
        _end.Cancel();
        _server.Dispose();
        foreach (TestConnection connection in _connections)
            connection.Dispose();
    }

    private async Task AcceptAllAsync(Func<TestConnection, Task> greet)
    {
        while (true)
        {
            TestConnection connection = await _server.AcceptAsync(_end.Token);
            _connections.Enqueue(connection);

            // Dispose may have run before.
            if (_end.IsCancellationRequested)
                connection.Dispose();

            _ = ServeAsync(connection, _connections.Count - 1, greet);
        }
    }

    private async Task ServeAsync(TestConnection connection, int number, Func<TestConnection, Task> greet)
    {
        try
        {
            await greet(connection);
            byte[] header = new byte[CommandChannelHeader.Size];
            while (await TryReadAsync(connection.Socket, header))
            {
                Assert.True(CommandChannelHeader.TryRead(header, out CommandChannelHeader read));
                byte[] payload = new byte[read.PayloadSize];
                if (!await TryReadAsync(connection.Socket, payload))
                    return;

                await _answer(new ScriptedRequest(connection, Interlocked.Increment(ref _requests) - 1, number, header, payload));
            }
        }
        catch (Exception exception) when (exception is SocketException or ObjectDisposedException or OperationCanceledException)
        {
            // The client gave the connection up, or the script closed it.
        }
    }

    private async Task<bool> TryReadAsync(Socket socket, Memory<byte> destination)
    {
        while (destination.Length > 0)
        {
            int count = await socket.ReceiveAsync(destination, SocketFlags.None, _end.Token);
            if (count == 0)
                return false;

            destination = destination[count..];
        }

        return true;
    }
}

internal sealed record ScriptedRequest(TestConnection Connection, int Number, int ConnectionNumber, byte[] Header, byte[] Payload)
{
    public int Id => BinaryPrimitives.ReadUInt16LittleEndian(Header.AsSpan(4));

    public int Avatar => BinaryPrimitives.ReadInt32LittleEndian(Payload);

    public byte[] Packet => [.. Header, .. Payload];

    public Task ReplyAsync(byte[] payload, int? id = null) => Connection.SendAsync(CommandScript.Packet(payload, id ?? Id));

    public Task SendAsync(byte[] bytes) => Connection.SendAsync(bytes);
}
