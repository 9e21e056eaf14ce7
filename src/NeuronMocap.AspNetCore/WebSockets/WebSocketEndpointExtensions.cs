using Microsoft.AspNetCore.Routing;
using NeuronMocap.AspNetCore;

namespace Microsoft.AspNetCore.Builder;

/// <summary>Gives a <see cref="WebSocketBroadcaster"/> an address in a web application.</summary>
public static class WebSocketEndpointExtensions
{
    /// <summary>Serves the WebSocket clients of a path. Other requests to it get a status and a sentence: 400, 401, 403 or 503.</summary>
    /// <param name="endpoints">The application.</param>
    /// <param name="pattern">The path, such as <c>/motion</c>.</param>
    /// <param name="broadcaster">The broadcaster, which its owner disposes. The application need not use the middleware for WebSockets.</param>
    /// <returns>A builder for further conventions, such as an authorization policy or a limit of requests.</returns>
    public static IEndpointConventionBuilder MapNeuronWebSocket(this IEndpointRouteBuilder endpoints, string pattern, WebSocketBroadcaster broadcaster)
    {
        ArgumentNullException.ThrowIfNull(endpoints);
        ArgumentNullException.ThrowIfNull(pattern);
        ArgumentNullException.ThrowIfNull(broadcaster);
        IApplicationBuilder application = endpoints.CreateApplicationBuilder().Use(LimitedInput.InsertAsync).UseWebSockets();
        application.Run(broadcaster.HandleAsync);
        return endpoints.Map(pattern, application.Build()).WithDisplayName($"Motion {pattern}");
    }
}
