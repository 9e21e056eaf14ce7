using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Routing;
using NeuronMocap.Tool.View.Performers;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Figures;

/// <summary>GET /api/performers/{key}/figure.glb: the figure with a performer's body.</summary>
/// <param name="find">Finds a performer.</param>
/// <param name="write">Writes the figure as GLB; null if there is no writer.</param>
internal sealed class FigureFiles(Func<PerformerKey, Performer?> find, Func<Performer, byte[]>? write) : IViewPart
{
    public void Map(IEndpointRouteBuilder endpoints) => endpoints.MapGet("/api/performers/{key}/figure.glb", HandleAsync);

    public ValueTask DisposeAsync() => ValueTask.CompletedTask;

    private Task HandleAsync(HttpContext context)
    {
        if (write is null || !PerformerKey.TryParse(context.Request.RouteValues["key"] as string, out PerformerKey key) || find(key) is not { } performer)
            throw ApiException.NotFound("There is no figure for this performer.");

        return SendAsync(context, write(performer));
    }

    private static Task SendAsync(HttpContext context, byte[] glb)
    {
        context.Response.ContentType = "model/gltf-binary";
        context.Response.ContentLength = glb.Length;
        return context.Response.Body.WriteAsync(glb, context.RequestAborted).AsTask();
    }
}
