using System.Net;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Routing;
using NeuronMocap.Commands;
using NeuronMocap.Protocol;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Actions;

/// <summary>POST /api/zero-out: sends the command to the source.</summary>
/// <param name="commands">The command channel of the source; null if it has none.</param>
/// <param name="localAddress">The address of this computer to connect from; null for the system's choice.</param>
internal sealed class ZeroOutAction(ServerAddress? commands, IPAddress? localAddress) : IViewPart
{
    public void Map(IEndpointRouteBuilder endpoints) => endpoints.MapPost("/api/zero-out", HandleAsync);

    public ValueTask DisposeAsync() => ValueTask.CompletedTask;

    private async Task HandleAsync(HttpContext context)
    {
        RequestJson request = context.Request.ContentLength is 0 or null && !context.Request.Headers.ContainsKey("Transfer-Encoding")
            ? new RequestJson(Avatar: null)
            : await ApiJson.ReadAsync<RequestJson>(context);
        if (commands is not { } server)
        {
            throw ApiException.Conflict(
                "The program does not know the command channel of this source. "
                + $"Start {ToolCommand.Name} view with --command-port, usually {ProtocolConstants.DefaultCommandPort}.");
        }

        if (request.Avatar < 0)
            throw ApiException.BadRequest("The number of an avatar is 0 or more.");

        await using var client = new NeuronCommandClient(new NeuronCommandOptions { Host = server.Host, Port = server.Port, LocalAddress = localAddress });
        try
        {
            await (request.Avatar is { } avatar ? client.ZeroOutAsync(avatar, context.RequestAborted) : client.ZeroOutAllAsync(context.RequestAborted));
        }
        catch (NeuronException exception)
        {
            throw new ApiException(StatusCodes.Status502BadGateway, OptionNames.Translate(exception.Message));
        }

        await ApiJson.WriteAsync(context, new AnswerJson(Done: true));
    }

    private sealed record RequestJson(int? Avatar);

    private sealed record AnswerJson(bool Done);
}
