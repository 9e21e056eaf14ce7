using System.Net.WebSockets;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Http.Features;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using NeuronMocap.AspNetCore.Connections;

namespace NeuronMocap.AspNetCore;

/// <summary>Sends what a reader receives to WebSocket clients: browsers and other programs. <c>MapNeuronWebSocket</c> gives it an address.</summary>
/// <remarks>
/// <para>
/// Each client chooses the form of its messages by the subprotocol, and its rate by the query: see <see cref="WebSocketForm"/> and
/// <see cref="WebSocketBroadcasterOptions.MaxRate"/>. A client that is too slow gets the newest frames of each avatar and loses older ones. It affects neither the
/// reader nor other clients. The page docs/guide/web.md describes the messages.
/// </para>
/// <para>
/// All members are thread-safe. A frame is encoded once for each form in use, on a pool thread. In steady state, encoding it and handing it to the clients allocates
/// nothing; sending to a client that does not keep up does.
/// </para>
/// </remarks>
public sealed class WebSocketBroadcaster : IAsyncDisposable
{
    private const string Stopping = "The server stops.";

    private static readonly WebSocketForm[] Forms = Enum.GetValues<WebSocketForm>();

    private static readonly TimeSpan CheckPeriod = TimeSpan.FromSeconds(0.25);

    // Sends a frame of WebSockets now and then, so that the system notices a client that is gone while no motion flows.
    private static readonly TimeSpan KeepAliveInterval = TimeSpan.FromSeconds(15);

    private readonly object _lock = new();
    private readonly WebSocketBroadcasterOptions _options;
    private readonly FrameQueue _queue;
    private readonly Func<AvatarFrame, WebSocketForm, MotionMessage?> _encode;
    private readonly Action<AvatarFrame> _publish;
    private readonly Timer _watchdog;
    private readonly Task _pump;
    private readonly TaskCompletionSource _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly TaskCompletionSource _served = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private WebSocketClient[] _clients = [];
    private WebSocketBroadcasterStatistics _departed;
    private int _places;
    private bool _hasEnded;

    /// <summary>Creates a broadcaster, which takes the reader's frames from now on.</summary>
    /// <param name="reader">The reader. Its owner starts it and disposes it. When it stops, or if it has already stopped, the clients are disconnected.</param>
    /// <param name="options">The options, which are copied; null for the defaults.</param>
    /// <exception cref="ArgumentException">An option is out of range; the message names it.</exception>
    public WebSocketBroadcaster(NeuronReader reader, WebSocketBroadcasterOptions? options = null)
        : this(reader, options, new MessageEncoder().Encode)
    {
    }

    // Tests replace the encoder, which does not fail otherwise.
    internal WebSocketBroadcaster(NeuronReader reader, WebSocketBroadcasterOptions? options, Func<AvatarFrame, WebSocketForm, MotionMessage?> encode)
    {
        ArgumentNullException.ThrowIfNull(reader);
        _options = (options ?? new WebSocketBroadcasterOptions()).CopyChecked(nameof(options));
        _queue = reader.OpenQueue(new FrameQueueOptions { Name = "websocket", WhenFull = WhenFull.DropOldest });
        _encode = encode;
        _publish = Publish;
        _watchdog = new Timer(_ => AbortStuck(), state: null, CheckPeriod, CheckPeriod);
        _pump = Task.Run(PumpAsync);
    }

    /// <summary>Completes when the reader has stopped or the broadcaster is disposed. No frame is taken from the reader after that.</summary>
    /// <remarks>The task fails if a frame cannot be encoded, because memory is short or this library has an error. All clients are disconnected then.</remarks>
    public Task Completion => _completion.Task;

    /// <summary>Gets the totals since the creation.</summary>
    /// <returns>A snapshot.</returns>
    public WebSocketBroadcasterStatistics GetStatistics()
    {
        lock (_lock)
        {
            return _clients.Aggregate(_departed, static (sum, client) => sum.Add(client.Statistics)) with
            {
                Clients = _clients.Length,
                FramesMissed = _queue.Dropped,
            };
        }
    }

    /// <summary>Gets the clients that are connected, each with its counters.</summary>
    /// <returns>A new list.</returns>
    public IReadOnlyList<WebSocketClientStatistics> GetClients() => [.. Volatile.Read(ref _clients).Select(static client => client.Statistics)];

    /// <summary>Disconnects all clients, and takes no further frames from the reader. Can be called repeatedly.</summary>
    /// <returns>A task that completes when the clients are served no more, which takes a few seconds at most. It does not fail.</returns>
    public async ValueTask DisposeAsync()
    {
        EndAll(WebSocketCloseStatus.EndpointUnavailable, Stopping);
        _queue.Dispose();
        await _pump.ConfigureAwait(false);

        // The watchdog ends clients that do not read.
        await _served.Task.ConfigureAwait(false);
        await _watchdog.DisposeAsync().ConfigureAwait(false);
    }

    // Serves one request, to its end.
    internal async Task HandleAsync(HttpContext context)
    {
        (WebSocketRequest? request, Refusal? refusal) = WebSocketRequest.Read(context, _options);
        if (request is null)
        {
            await RefuseAsync(context, refusal!).ConfigureAwait(false);
            return;
        }

        if (!TryReserve())
        {
            await RefuseAsync(context, new Refusal(StatusCodes.Status503ServiceUnavailable, "The server has no room for another client, or its stream has ended.")).ConfigureAwait(false);
            return;
        }

        WebSocketClient? client = null;
        try
        {
            if (HttpProtocol.IsHttp11(context.Request.Protocol))
                ConnectionSocket.Prepare(context.Features);

            using LimitedInput input = context.Features.GetRequiredFeature<LimitedInput>();
            using WebSocket socket = await context.WebSockets.AcceptWebSocketAsync(
                new WebSocketAcceptContext { SubProtocol = request.Subprotocol, KeepAliveInterval = KeepAliveInterval }).ConfigureAwait(false);
            client = new WebSocketClient(socket, input, request, context);
            await ServeAsync(client, context).ConfigureAwait(false);
        }
        finally
        {
            Leave(client);
        }
    }

    private async Task ServeAsync(WebSocketClient client, HttpContext context)
    {
        Add(client);
        CancellationToken stopping = context.RequestServices.GetService<IHostApplicationLifetime>()?.ApplicationStopping ?? CancellationToken.None;
        using (stopping.Register(() => client.End(WebSocketCloseStatus.EndpointUnavailable, Stopping)))
            await client.RunAsync().ConfigureAwait(false);
    }

    private async Task RefuseAsync(HttpContext context, Refusal refusal)
    {
        lock (_lock)
            _departed = _departed with { Refused = _departed.Refused + 1 };

        context.Response.StatusCode = refusal.Status;
        context.Response.ContentType = "text/plain; charset=utf-8";
        if (refusal.Status == StatusCodes.Status401Unauthorized)
            context.Response.Headers.WWWAuthenticate = "Bearer";

        await context.Response.WriteAsync(refusal.Reason + "\n", context.RequestAborted).ConfigureAwait(false);
    }

    private bool TryReserve()
    {
        lock (_lock)
        {
            bool isFree = !_hasEnded && _places < _options.MaxClients;
            _places += isFree ? 1 : 0;
            return isFree;
        }
    }

    // When a client is no longer counted, its place is free. Null if the connection ended before there was a client.
    private void Leave(WebSocketClient? client)
    {
        lock (_lock)
        {
            if (client is not null)
            {
                _clients = [.. _clients.Where(each => each != client)];
                _departed = _departed.Add(client.Statistics);
            }

            _places--;
            if (_hasEnded && _places == 0)
                _served.TrySetResult();
        }
    }

    private void Add(WebSocketClient client)
    {
        lock (_lock)
        {
            _clients = [.. _clients, client];
            _departed = _departed with { Accepted = _departed.Accepted + 1 };
            if (_hasEnded)
                client.End(WebSocketCloseStatus.EndpointUnavailable, Stopping);
        }
    }

    private async Task PumpAsync()
    {
        try
        {
            while (await _queue.WaitAsync().ConfigureAwait(false))
                _queue.Pump(_publish);

            EndAll(WebSocketCloseStatus.EndpointUnavailable, "The stream has ended.");
            _completion.TrySetResult();
        }
        catch (Exception exception)
        {
            EndAll(WebSocketCloseStatus.InternalServerError, "The server has failed.");
            _queue.Dispose();
            _completion.TrySetException(exception);
        }
    }

    private void Publish(AvatarFrame frame)
    {
        WebSocketClient[] clients = Volatile.Read(ref _clients);
        foreach (WebSocketForm form in Forms)
        {
            MotionMessage? message = null;
            foreach (WebSocketClient client in clients)
            {
                if (client.Form != form)
                    continue;

                message ??= _encode(frame, form);
                if (message is null)
                    break;

                client.Put(message);
            }

            message?.Release();
        }
    }

    private void EndAll(WebSocketCloseStatus status, string reason)
    {
        lock (_lock)
        {
            _hasEnded = true;
            foreach (WebSocketClient client in _clients)
                client.End(status, reason);

            if (_places == 0)
                _served.TrySetResult();
        }
    }

    private void AbortStuck()
    {
        foreach (WebSocketClient client in Volatile.Read(ref _clients))
            client.AbortIfStuck(_options.ClientTimeout);
    }
}
