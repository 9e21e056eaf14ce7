using System.Globalization;
using Microsoft.AspNetCore.Http;

namespace NeuronMocap.AspNetCore;

/// <summary>Why a request is not accepted.</summary>
/// <param name="Status">The HTTP status.</param>
/// <param name="Reason">A sentence for the developer of the client.</param>
internal sealed record Refusal(int Status, string Reason);

/// <summary>What a client asks for.</summary>
/// <param name="Form">The form of its messages.</param>
/// <param name="Subprotocol">The name of the form; null if the client asked for none.</param>
/// <param name="MaxRate">Frames per second of each avatar; 0 for all.</param>
internal sealed record WebSocketRequest(WebSocketForm Form, string? Subprotocol, double MaxRate)
{
    private static readonly (string Name, WebSocketForm Form)[] Forms = [("json", WebSocketForm.Json), ("packet", WebSocketForm.Packet), ("pose", WebSocketForm.Pose)];

    /// <summary>Reads a request, or finds out why it is refused.</summary>
    public static (WebSocketRequest? Request, Refusal? Refusal) Read(HttpContext context, WebSocketBroadcasterOptions options)
    {
        string origin = context.Request.Headers.Origin.ToString();
        if (origin.Length > 0 && !AllowedOrigin.Allows(options.AllowedOrigins, origin))
            return Refuse(StatusCodes.Status403Forbidden, "The server does not allow pages of this origin. Its setting AllowedOrigins, or --allow-origin, lists those that it allows.");
        if (options.Token is { } token && !AccessToken.IsIn(context.Request, token))
            return Refuse(StatusCodes.Status401Unauthorized, "The token is missing or wrong. Send the header Authorization: Bearer TOKEN, or ?token=TOKEN.");
        if (!context.WebSockets.IsWebSocketRequest)
            return Refuse(StatusCodes.Status400BadRequest, "This address sends motion to WebSocket clients. Connect with ws:// or wss://.");
        if (!TryReadRate(context.Request, out double rate))
            return Refuse(StatusCodes.Status400BadRequest, "The rate is not a number from 0.01 to 1000.");

        IList<string> wanted = context.WebSockets.WebSocketRequestedProtocols;
        string? name = wanted.FirstOrDefault(static name => Forms.Any(form => form.Name.Equals(name, StringComparison.Ordinal)));
        if (name is null && wanted.Count > 0)
            return Refuse(StatusCodes.Status400BadRequest, $"None of the subprotocols is known. Use {string.Join(", ", Forms.SkipLast(1).Select(static form => form.Name))} or {Forms[^1].Name}.");

        double limit = (rate, options.MaxRate) switch
        {
            (0, var most) => most,
            (var asked, 0) => asked,
            var (asked, most) => Math.Min(asked, most),
        };
        return (new WebSocketRequest(name is null ? WebSocketForm.Json : Array.Find(Forms, form => form.Name.Equals(name, StringComparison.Ordinal)).Form, name, limit), null);
    }

    private static (WebSocketRequest? Request, Refusal? Refusal) Refuse(int status, string reason) => (null, new Refusal(status, reason));

    private static bool TryReadRate(HttpRequest request, out double rate)
    {
        rate = 0;
        return !request.Query.TryGetValue("rate", out var text)
            || (double.TryParse(text.ToString(), NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out rate) && rate is >= 0.01 and <= 1000);
    }
}
