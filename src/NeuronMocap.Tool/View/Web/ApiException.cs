using Microsoft.AspNetCore.Http;

namespace NeuronMocap.Tool.View.Web;

/// <summary>A request that cannot be answered. The page gets the status, and the message as its error.</summary>
/// <param name="status">A status of HTTP from 400.</param>
/// <param name="message">One sentence for the user of the page.</param>
internal sealed class ApiException(int status, string message) : Exception(message)
{
    public int Status => status;

    /// <summary>Something that the address names does not exist.</summary>
    public static ApiException NotFound(string message) => new(StatusCodes.Status404NotFound, message);

    /// <summary>The request contains something wrong.</summary>
    public static ApiException BadRequest(string message) => new(StatusCodes.Status400BadRequest, message);

    /// <summary>The request is right, but not possible now.</summary>
    public static ApiException Conflict(string message) => new(StatusCodes.Status409Conflict, message);
}
