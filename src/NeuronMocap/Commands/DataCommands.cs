using NeuronMocap.Delivery;
using NeuronMocap.Protocol;

namespace NeuronMocap.Commands;

/// <summary>
/// The commands of the old generation, which share a reader's TCP connection with its frames (protocol.md section 7): servers of the time of
/// the vendor's b11 and b12 libraries answer them; newer ones have a connection of their own for commands.
/// <para>
/// Requests are sent when asked for; replies come whenever the server likes, between frames. Take them as they come with
/// <see cref="Received"/>, or await one value with <see cref="GetAvatarCountAsync"/> and its like. All members may be called from any thread.
/// </para>
/// </summary>
public sealed class DataCommands
{
    private static readonly TimeSpan ShortestTimeout = TimeSpan.FromMilliseconds(1);
    private static readonly TimeSpan LongestTimeout = TimeSpan.FromHours(1);

    private readonly TrySend _trySend;
    private readonly HandlerList<DataCommandReply> _handlers;
    private readonly ReplyWaiters _waiters = new();
    private readonly object _lock = new();
    private readonly SortedSet<DataCommandId> _registered = [];
    private readonly Turns _sizes = new();
    private readonly Turns _texts = new();
    private TimeSpan _timeout = TimeSpan.FromSeconds(3);

    internal DataCommands(TrySend trySend, Action<Exception> failed)
    {
        _trySend = trySend;
        _handlers = new HandlerList<DataCommandReply>(failed);
    }

    /// <summary>How long <see cref="GetAvatarCountAsync"/> and its like wait for a reply, counted from the sending. 3 s unless set; 1 ms to an hour.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is out of range.</exception>
    public TimeSpan Timeout
    {
        get => _timeout;
        set => _timeout = value >= ShortestTimeout && value <= LongestTimeout
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "Timeout is 1 ms to an hour.");
    }

    // False where no connection stands that commands can travel on, or where it takes no more bytes for a second.
    internal delegate bool TrySend(ReadOnlySpan<byte> bytes);

    /// <summary>Called with every reply, on the receive thread, in the order of arrival. While a handler runs, nothing is received.</summary>
    public event Action<DataCommandReply>? Received
    {
        add => _handlers.Add(value);
        remove => _handlers.Remove(value);
    }

    /// <summary>Asks for a value that is not an avatar's own. The reply comes to <see cref="Received"/>.</summary>
    /// <param name="id">What to ask for.</param>
    /// <returns>False when the request could not be sent: no connection stands, or frames come over UDP.</returns>
    public bool TryRequest(DataCommandId id) => TryRequest(id, avatarIndex: 0);

    /// <summary>Asks for a value of an avatar. The reply comes to <see cref="Received"/>.</summary>
    /// <param name="id">What to ask for.</param>
    /// <param name="avatarIndex">Number of the avatar on the server, from 0.</param>
    /// <returns>False when the request could not be sent: no connection stands, or frames come over UDP.</returns>
    public bool TryRequest(DataCommandId id, int avatarIndex) => TrySendRequest(id, avatarIndex);

    /// <summary>
    /// Asks the server to send a value whenever it changes ("auto-sync"); it comes to <see cref="Received"/>. Asked for again by itself
    /// after every reconnect, until <see cref="TryUnregister"/>.
    /// </summary>
    /// <param name="id">What to watch.</param>
    /// <returns>False when the request could not be sent; then nothing is registered.</returns>
    public bool TryRegister(DataCommandId id)
    {
        lock (_lock)
        {
            bool sent = TrySendRequest(DataCommandId.RegisterEvent, (int)id);
            if (sent)
                _registered.Add(id);

            return sent;
        }
    }

    /// <summary>Asks the server to send a value no more by itself.</summary>
    /// <param name="id">What was watched.</param>
    /// <returns>False when the request could not be sent; it is not registered again after a reconnect all the same.</returns>
    public bool TryUnregister(DataCommandId id)
    {
        lock (_lock)
        {
            _registered.Remove(id);
            return TrySendRequest(DataCommandId.UnregisterEvent, (int)id);
        }
    }

    /// <summary>
    /// Asks for names and lengths of an avatar's bones. Replies do not say whose they are: so one is asked for after the other, and after one that did
    /// not come in time the next call asks for the number of avatars first, behind whose reply no late one can come. Only a change that the server
    /// sends by itself, after <see cref="TryRegister"/>, may be taken for the reply.
    /// </summary>
    /// <param name="avatarIndex">Number of the avatar on the server, from 0.</param>
    /// <param name="cancellationToken">Ends the wait with an <see cref="OperationCanceledException"/>.</param>
    /// <returns>The bones in the order of the server.</returns>
    /// <exception cref="NeuronCommandException">The request could not be sent, no reply came in time, or the connection ended.</exception>
    public async Task<IReadOnlyList<BoneSize>> GetBoneSizesAsync(int avatarIndex = 0, CancellationToken cancellationToken = default) =>
        (await RequestInTurnAsync(_sizes, DataCommandId.BoneSize, avatarIndex, cancellationToken).ConfigureAwait(false)).BoneSizes!;

    /// <summary>Asks for an avatar's hierarchy; whose it is, see <see cref="GetBoneSizesAsync"/>.</summary>
    /// <param name="avatarIndex">Number of the avatar on the server, from 0.</param>
    /// <param name="cancellationToken">Ends the wait with an <see cref="OperationCanceledException"/>.</param>
    /// <returns>The text of a BVH file's hierarchy, as the server sent it.</returns>
    /// <exception cref="NeuronCommandException">The request could not be sent, no reply came in time, or the connection ended.</exception>
    public async Task<string> GetBvhTextAsync(int avatarIndex = 0, CancellationToken cancellationToken = default) =>
        (await RequestInTurnAsync(_texts, DataCommandId.BvhText, avatarIndex, cancellationToken).ConfigureAwait(false)).BvhText!;

    /// <summary>Asks for the number of avatars on the server.</summary>
    /// <param name="cancellationToken">Ends the wait with an <see cref="OperationCanceledException"/>.</param>
    /// <returns>The number as the server sent it.</returns>
    /// <exception cref="NeuronCommandException">The request could not be sent, no reply came in time, or the connection ended.</exception>
    public async Task<int> GetAvatarCountAsync(CancellationToken cancellationToken = default) =>
        (await RequestAsync(DataCommandId.AvatarCount, avatarIndex: 0, cancellationToken).ConfigureAwait(false)).AvatarCount!.Value;

    /// <summary>Asks for an avatar's frequency. A reply for another avatar is passed over.</summary>
    /// <param name="avatarIndex">Number of the avatar on the server, from 0.</param>
    /// <param name="cancellationToken">Ends the wait with an <see cref="OperationCanceledException"/>.</param>
    /// <returns>Frames per second.</returns>
    /// <exception cref="NeuronCommandException">The request could not be sent, no reply came in time, or the connection ended.</exception>
    public async Task<int> GetFrequencyAsync(int avatarIndex = 0, CancellationToken cancellationToken = default) =>
        (await RequestAsync(DataCommandId.DataFrequency, avatarIndex, cancellationToken).ConfigureAwait(false)).Frequency!.Value;

    /// <summary>Asks for which sensors an avatar wears. A reply for another avatar is passed over.</summary>
    /// <param name="avatarIndex">Number of the avatar on the server, from 0.</param>
    /// <param name="cancellationToken">Ends the wait with an <see cref="OperationCanceledException"/>.</param>
    /// <returns>The mode; servers may send numbers that the enumeration lacks.</returns>
    /// <exception cref="NeuronCommandException">The request could not be sent, no reply came in time, or the connection ended.</exception>
    public async Task<SensorCombination> GetCombinationModeAsync(int avatarIndex = 0, CancellationToken cancellationToken = default) =>
        (await RequestAsync(DataCommandId.CombinationMode, avatarIndex, cancellationToken).ConfigureAwait(false)).CombinationMode!.Value;

    // Receive thread.
    internal void OnPacket(in ReceivedPacket packet)
    {
        if (_handlers.IsEmpty && _waiters.IsEmpty)
            return;

        var reply = new DataCommandReply(packet.Bytes);
        _waiters.Complete(reply);
        _handlers.Invoke(reply);
    }

    // A connection stands, which knows of no registration.
    internal void OnLinkOpened()
    {
        lock (_lock)
        {
            foreach (DataCommandId id in _registered)
                TrySendRequest(DataCommandId.RegisterEvent, (int)id);
        }
    }

    // The connection is gone, and no reply will come.
    internal void OnLinkClosed()
    {
        (_sizes.HasLateReply, _texts.HasLateReply) = (false, false);
        _waiters.FailAll();
    }

    private async Task<DataCommandReply> RequestInTurnAsync(Turns turns, DataCommandId id, int avatarIndex, CancellationToken cancellationToken)
    {
        await turns.Free.WaitAsync(cancellationToken).ConfigureAwait(false);
        try
        {
            if (turns.HasLateReply)
                await RequestAsync(DataCommandId.AvatarCount, avatarIndex: 0, cancellationToken).ConfigureAwait(false);

            turns.HasLateReply = true;
            DataCommandReply reply = await RequestAsync(id, avatarIndex, cancellationToken).ConfigureAwait(false);
            turns.HasLateReply = false;
            return reply;
        }
        finally
        {
            turns.Free.Release();
        }
    }

    private async Task<DataCommandReply> RequestAsync(DataCommandId id, int avatarIndex, CancellationToken cancellationToken)
    {
        cancellationToken.ThrowIfCancellationRequested();
        ReplyWaiters.Waiter waiter = _waiters.Add(reply => reply.Id == id && (reply.AvatarIndex ?? avatarIndex) == avatarIndex);
        try
        {
            if (!TryRequest(id, avatarIndex))
            {
                throw new NeuronCommandException(
                    CommandFailure.NotConnected,
                    "The command could not be sent: it needs a reader that is connected over TCP. Start the reader first, and wait for its connection.");
            }

            using var timeoutSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken);
            timeoutSource.CancelAfter(Timeout);
            using (timeoutSource.Token.Register(() => waiter.Reply.TrySetCanceled(timeoutSource.Token)))
                return await waiter.Reply.Task.ConfigureAwait(false);
        }
        catch (OperationCanceledException) when (!cancellationToken.IsCancellationRequested)
        {
            throw new NeuronCommandException(
                CommandFailure.TimedOut,
                $"No reply to the command {id} came within {Timeout.TotalSeconds:0.#} s. Servers newer than b12 do not take commands on the data "
                + "connection: use the command port, by default 8013.");
        }
        finally
        {
            _waiters.Remove(waiter);
        }
    }

    private bool TrySendRequest(DataCommandId id, int parameter)
    {
        Span<byte> request = stackalloc byte[ProtocolConstants.HeaderSize];
        new DataCommandHeader { CommandId = id, Parameter = parameter }.Write(request);
        return _trySend(request);
    }

    // Of requests whose replies do not tell the avatar: one at a time. A server answers in the order of the requests.
    private sealed class Turns
    {
        private volatile bool _hasLateReply;

        public SemaphoreSlim Free { get; } = new(1);

        // Whether the reply to a request that nobody waits for any more may still come.
        public bool HasLateReply
        {
            get => _hasLateReply;
            set => _hasLateReply = value;
        }
    }
}
