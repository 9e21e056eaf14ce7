using System.Net.WebSockets;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Http.Features;
using Microsoft.AspNetCore.Routing;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using NeuronMocap.AspNetCore;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Control;

/// <summary>The sockets of all pages for messages in JSON: /control. Also answers /api/hello. Thread-safe.</summary>
/// <param name="greeting">Makes the messages that a new page gets, hello first. Must not wait for a thread that sends.</param>
internal sealed class ControlHub(Func<IReadOnlyList<object>> greeting) : IViewPart
{
    private const int MostClients = 100;

    // So that the system notices a page that is gone while nothing happens.
    private static readonly TimeSpan KeepAliveInterval = TimeSpan.FromSeconds(15);

    private readonly Lock _lock = new();
    private readonly List<ControlClient> _clients = [];
    private bool _hasEnded;

    /// <summary>Called after a page came or left, on any thread.</summary>
    public event Action? ClientsChanged;

    /// <summary>Number of pages that listen.</summary>
    public int Clients
    {
        get
        {
            lock (_lock)
                return _clients.Count;
        }
    }

    public void Map(IEndpointRouteBuilder endpoints)
    {
        IApplicationBuilder application = endpoints.CreateApplicationBuilder()
            .Use(LimitedInput.InsertAsync)
            .UseWebSockets(new WebSocketOptions { KeepAliveInterval = KeepAliveInterval });
        application.Run(HandleAsync);
        endpoints.Map("/control", application.Build());
        endpoints.MapGet("/api/hello", context => ApiJson.WriteAsync(context, greeting()[0]));
    }

    /// <summary>Sends a message to every page. A page that does not read is disconnected.</summary>
    public void Send(object message) => SendCurrent(() => message);

    /// <summary>Makes and sends a message under the lock, so that no newer one is sent before it.</summary>
    /// <param name="describe">Makes the message, or null for none. Must not wait for a thread that sends.</param>
    public void SendCurrent(Func<object?> describe)
    {
        lock (_lock)
        {
            if (_clients.Count == 0 || describe() is not { } message)
                return;

            byte[] bytes = ApiJson.ToBytes(message);
            foreach (ControlClient client in _clients)
                client.Put(bytes);
        }
    }

    public ValueTask DisposeAsync()
    {
        EndAll();
        return ValueTask.CompletedTask;
    }

    private async Task HandleAsync(HttpContext context)
    {
        if (!context.WebSockets.IsWebSocketRequest)
            throw ApiException.BadRequest("This address is a WebSocket.");
        if (Clients >= MostClients)
            throw new ApiException(StatusCodes.Status503ServiceUnavailable, "Too many pages are open.");

        using LimitedInput input = context.Features.GetRequiredFeature<LimitedInput>();
        using WebSocket socket = await context.WebSockets.AcceptWebSocketAsync();
        var client = new ControlClient(socket, input, context);
        Add(client);
        try
        {
            using (context.RequestServices.GetRequiredService<IHostApplicationLifetime>().ApplicationStopping.Register(EndAll))
                await client.RunAsync();
        }
        finally
        {
            lock (_lock)
                _clients.Remove(client);

            ClientsChanged?.Invoke();
        }
    }

    // Under the lock, so that nothing is missing between the greeting and the first change.
    private void Add(ControlClient client)
    {
        lock (_lock)
        {
            foreach (object message in greeting())
                client.Put(ApiJson.ToBytes(message));

            _clients.Add(client);
            if (_hasEnded)
                client.End(WebSocketCloseStatus.EndpointUnavailable, ControlClient.Stopping);
        }

        ClientsChanged?.Invoke();
    }

    private void EndAll()
    {
        lock (_lock)
        {
            _hasEnded = true;
            foreach (ControlClient client in _clients)
                client.End(WebSocketCloseStatus.EndpointUnavailable, ControlClient.Stopping);
        }
    }
}
