using Microsoft.AspNetCore.Routing;

namespace NeuronMocap.Tool.View.Web;

/// <summary>A part of the server with its own addresses. Access is checked before a request comes here.</summary>
/// <remarks>A handler throws an <see cref="ApiException"/> for a request that it cannot answer.</remarks>
internal interface IViewPart : IAsyncDisposable
{
    /// <summary>Maps the addresses of this part. Called once, before the server starts.</summary>
    void Map(IEndpointRouteBuilder endpoints);
}
