using System.Net;
using NeuronMocap.Bvh;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Transport;

namespace NeuronMocap.Commands;

/// <summary>
/// A client for the command channel, a TCP connection beside that of the stream (manual sections 2.3.9 to 2.3.14, protocol.md section 6). It reads
/// settings and bodies that the stream does not contain, and can zero out avatars.
/// </summary>
/// <remarks>
/// <para>
/// The client connects when it is first needed. It connects again whenever the existing connection is not safe to use.
/// </para>
/// <para>
/// Thread-safe. Calls are executed one at a time, in the order of the calls. You can block on the tasks on any thread, even on a reader's receive thread,
/// because the client needs no pool thread. Between calls it has no thread at all.
/// </para>
/// <para>
/// A call ends with the server's answer or with an exception, never with the answer to another call. It throws:
/// </para>
/// <list type="bullet">
/// <item><description>a <see cref="NeuronCommandException"/> for every failure of the network or the server;</description></item>
/// <item><description>an <see cref="OperationCanceledException"/> at once when it is cancelled, in any phase;</description></item>
/// <item><description>an <see cref="ObjectDisposedException"/> when the client is disposed.</description></item>
/// </list>
/// <para>
/// The client stays usable after a failure or a cancellation. The server may have executed a command that was cancelled or timed out. If the server closes
/// an already used connection without any answer, the client sends the request once more on a new connection.
/// </para>
/// </remarks>
public sealed class NeuronCommandClient : IDisposable, IAsyncDisposable
{
    private static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(2);

    private readonly object _lock = new();
    private readonly NeuronCommandOptions _options;
    private readonly LinkOptions _link;
    private readonly CommandReplies _replies;
    private readonly LinkedList<CommandRequest> _queue = [];
    private Task _working = Task.CompletedTask;
    private CommandRequest? _current;
    private CommandConnection? _connection;
    private bool _isWorking;
    private bool _isConnecting;
    private bool _isDisposed;

    /// <summary>Creates a client; it does not connect yet.</summary>
    /// <param name="host">Name or address of the computer that runs Axis Neuron.</param>
    /// <param name="port">TCP port of its command channel.</param>
    /// <exception cref="ArgumentException">The name is empty, or the port is out of range.</exception>
    public NeuronCommandClient(string host, int port = ProtocolConstants.DefaultCommandPort)
        : this(new NeuronCommandOptions { Host = host, Port = port })
    {
    }

    /// <summary>Creates a client; it does not connect yet.</summary>
    /// <param name="options">The options; copied.</param>
    /// <exception cref="ArgumentException">An option is out of range; the message names it.</exception>
    public NeuronCommandClient(NeuronCommandOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        if (options.FindFault() is { } fault)
            throw new ArgumentException($"NeuronCommandOptions: {fault}", nameof(options));

        _options = options.Copy();
        _link = _options.Link;
        _replies = new CommandReplies(_link.Target);
    }

    // Tests replace it, because the behaviour of a resolver without a network is not predictable.
    internal Func<string, IPAddress[]> Resolve { get; init; } = Dns.GetHostAddresses;

    // Whether the server has closed the connection that the next command would use. While no command runs, nothing else checks this.
    internal bool IsLeft
    {
        get
        {
            lock (_lock)
                return !_isWorking && _connection?.IsLeft == true;
        }
    }

    // Whether the current command waits for a connection, or failed because it got none.
    internal bool IsConnecting
    {
        get
        {
            lock (_lock)
                return _isConnecting;
        }
    }

    /// <summary>Connects, if there is no usable connection. This call is optional; use it to find out early whether the server is available.</summary>
    /// <param name="cancellationToken">Cancels the call.</param>
    /// <returns>A task that completes when the client is connected.</returns>
    /// <exception cref="NeuronCommandException">The connection failed.</exception>
    public Task ConnectAsync(CancellationToken cancellationToken = default) =>
        Enqueue(new CommandRequest<bool>(id: null, avatar: null, static _ => true), cancellationToken);

    /// <summary>Asks the server to zero out an avatar (manual section 2.3.10).</summary>
    /// <remarks>
    /// The effect, on direction, position or both, is not documented. The simulator turns the avatar to face front where it stands.
    /// </remarks>
    /// <param name="avatarIndex">Index of the avatar, from 0, as in its frames.</param>
    /// <param name="cancellationToken">Cancels the call.</param>
    /// <returns>A task that completes when the server confirms the command.</returns>
    /// <exception cref="NeuronCommandException">The server did not answer, or refused because the avatar does not exist.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The index is negative.</exception>
    public Task ZeroOutAsync(int avatarIndex, CancellationToken cancellationToken = default) => Enqueue(
        new CommandRequest<bool>(
            CommandChannelId.ZeroOut, Checked(avatarIndex), payload => _replies.ReadZeroOut(payload, avatarIndex)),
        cancellationToken);

    /// <summary>Asks the server to zero out all avatars (manual section 2.3.11), as <see cref="ZeroOutAsync"/> does for one avatar.</summary>
    /// <param name="cancellationToken">Cancels the call.</param>
    /// <returns>A task that completes when the server confirms the command.</returns>
    /// <exception cref="NeuronCommandException">The server did not answer, or refused.</exception>
    public Task ZeroOutAllAsync(CancellationToken cancellationToken = default) => Enqueue(
        new CommandRequest<bool>(CommandChannelId.ZeroOutAll, avatar: null, payload => _replies.ReadZeroOut(payload, avatar: null)),
        cancellationToken);

    /// <summary>
    /// Gets the order of the rotation values in the server's stream (manual section 2.3.12). A frame of Axis Neuron does not contain it.
    /// </summary>
    /// <param name="cancellationToken">Cancels the call.</param>
    /// <returns>The order, which applies to all avatars.</returns>
    /// <exception cref="NeuronCommandException">The server did not answer, or the answer is not one of the six orders.</exception>
    public Task<RotationOrder> GetRotationOrderAsync(CancellationToken cancellationToken = default) => Enqueue(
        new CommandRequest<RotationOrder>(CommandChannelId.RotationOrder, avatar: null, _replies.ReadRotationOrder), cancellationToken);

    /// <summary>Gets the sizes of an avatar's body (manual section 2.3.13).</summary>
    /// <param name="avatarIndex">Index of the avatar, from 0, as in its frames.</param>
    /// <param name="cancellationToken">Cancels the call.</param>
    /// <returns>The sizes, in metres.</returns>
    /// <exception cref="NeuronCommandException">The server did not answer, or the sizes are impossible for a body.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The index is negative.</exception>
    public Task<BoneDimensions> GetBoneDimensionsAsync(int avatarIndex, CancellationToken cancellationToken = default) => Enqueue(
        new CommandRequest<BoneDimensions>(
            CommandChannelId.BoneDimensions, Checked(avatarIndex), payload => _replies.ReadDimensions(payload, avatarIndex)),
        cancellationToken);

    /// <summary>Gets the header of an avatar's BVH file: its skeleton and the order of its channels (manual section 2.3.14 and Appendix B).</summary>
    /// <param name="avatarIndex">Index of the avatar, from 0, as in its frames.</param>
    /// <param name="cancellationToken">Cancels the call.</param>
    /// <returns>The header, as a document without frames. <see cref="BvhSkeletonMap"/> finds the bones in it.</returns>
    /// <exception cref="NeuronCommandException">The server did not answer, or the text is not BVH.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The index is negative.</exception>
    public Task<BvhDocument> GetBvhHeaderAsync(int avatarIndex, CancellationToken cancellationToken = default) =>
        GetHeader(avatarIndex, payload => _replies.ReadHeader(payload, avatarIndex).Document, cancellationToken);

    /// <summary>Gets the same header as <see cref="GetBvhHeaderAsync"/>, as the text that the server sent.</summary>
    /// <param name="avatarIndex">Index of the avatar, from 0, as in its frames.</param>
    /// <param name="cancellationToken">Cancels the call.</param>
    /// <returns>The text, with the server's line endings.</returns>
    /// <exception cref="NeuronCommandException">The server did not answer, or the text is not BVH.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The index is negative.</exception>
    public Task<string> GetBvhHeaderTextAsync(int avatarIndex, CancellationToken cancellationToken = default) =>
        GetHeader(avatarIndex, payload => _replies.ReadHeader(payload, avatarIndex).Text, cancellationToken);

    /// <summary>
    /// Closes the connection, and ends all pending calls with an <see cref="ObjectDisposedException"/>. Returns within 2 s, normally at once. Any thread,
    /// any number of times.
    /// </summary>
    public void Dispose() => Stop().Wait(StopTimeout);

    /// <summary>Does the same as <see cref="Dispose"/>, without blocking the caller.</summary>
    /// <returns>A task that completes when everything is closed, or after 2 s.</returns>
    public async ValueTask DisposeAsync() => await Task.WhenAny(Stop(), Task.Delay(StopTimeout)).ConfigureAwait(false);

    private static int Checked(int avatarIndex) => avatarIndex >= 0
        ? avatarIndex
        : throw new ArgumentOutOfRangeException(nameof(avatarIndex), avatarIndex, "The avatar number must not be negative.");

    private static ObjectDisposedException Disposed() => new(nameof(NeuronCommandClient), "The command client was disposed.");

    private Task<T> GetHeader<T>(int avatarIndex, ReplyParser<T> parse, CancellationToken cancellationToken) =>
        Enqueue(new CommandRequest<T>(CommandChannelId.BvhHeader, Checked(avatarIndex), parse), cancellationToken);

    private Task<T> Enqueue<T>(CommandRequest<T> request, CancellationToken cancellationToken)
    {
        // Registers before the request is queued, so the code that ends the request finds the registration. A cancelled token calls back here at once.
        request.Cancellation = cancellationToken.Register(() => Cancel(request, cancellationToken));
        lock (_lock)
        {
            if (_isDisposed)
                request.Fail(Disposed());
            else if (!request.IsCompleted)
                Add(request);
        }

        if (request.IsCompleted)
            request.Cancellation.Dispose();

        return request.Task;
    }

    private void Add(CommandRequest request)
    {
        _queue.AddLast(request);
        if (_isWorking)
            return;

        try
        {
            _working = DedicatedThread.RunAsync("NeuronMocap commands", Work);
            _isWorking = true;
            _isConnecting = _connection is null;
        }
        catch (OutOfMemoryException exception)
        {
            // The system has no thread left.
            _queue.Remove(request);
            request.Fail(exception);
        }
    }

    private void Cancel(CommandRequest request, CancellationToken cancellationToken)
    {
        lock (_lock)
        {
            if (request.Cancel(cancellationToken) && !_queue.Remove(request) && _current == request)
                _connection?.Close();
        }
    }

    private Task Stop()
    {
        CommandRequest[] queued;
        Task working;
        lock (_lock)
        {
            _isDisposed = true;
            queued = [.. _queue];
            foreach (CommandRequest request in queued)
                request.Fail(Disposed());
            _current?.Fail(Disposed());
            _queue.Clear();
            _connection?.Close();
            working = _working;
        }

        // Waits for running callbacks, so it must not run inside the lock. A token that outlives the client must not keep it.
        foreach (CommandRequest request in queued)
            request.Cancellation.Dispose();

        return working;
    }

    // The client's thread, which runs while there are requests.
    private void Work()
    {
        while (TryTake(out CommandRequest? request))
        {
            try
            {
                Carry(request);
            }
            catch (Exception exception)
            {
                // Closes the connection before the request fails. A caller that sees the failure then finds the connection closed.
                Drop();
                request.Fail(exception);
            }

            // Waits for a running callback, so it must not run inside the lock.
            request.Cancellation.Dispose();
        }
    }

    private bool TryTake([System.Diagnostics.CodeAnalysis.NotNullWhen(true)] out CommandRequest? request)
    {
        lock (_lock)
        {
            request = _queue.First?.Value;
            _current = request;
            _isWorking = request is not null;
            _isConnecting = request is not null && _connection?.CanAsk(request.Id) != true;
            if (request is not null)
                _queue.RemoveFirst();

            return _isWorking;
        }
    }

    private void Carry(CommandRequest request)
    {
        CommandConnection? kept = _connection;
        if (kept?.CanAsk(request.Id) == true)
        {
            try
            {
                Ask(kept, request);
                return;
            }
            catch (NeuronCommandException exception) when (exception.Reason == CommandFailure.Closed && !kept.HasHeard && !request.IsCompleted)
            {
                // The server closed the connection while the request was sent: it did not read the request, or ignored it.
            }
        }

        CommandConnection connection = Replace(request);
        connection.Open();
        Ask(connection, request);
    }

    private void Ask(CommandConnection connection, CommandRequest request)
    {
        lock (_lock)
            _isConnecting = false;

        if (request.Id is null)
            request.Complete(default);
        else
            connection.Ask(request);
    }

    private CommandConnection Replace(CommandRequest request)
    {
        var connection = new CommandConnection(_options, _link, Resolve);
        lock (_lock)
        {
            _connection?.Close();
            _connection = connection;
            _isConnecting = true;

            // The request was cancelled, or the client disposed, before there was a connection to close.
            if (request.IsCompleted)
                connection.Close();
        }

        return connection;
    }

    private void Drop()
    {
        lock (_lock)
            _connection?.Close();
    }
}
