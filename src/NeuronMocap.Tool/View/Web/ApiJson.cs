using System.Text.Encodings.Web;
using System.Text.Json;
using Microsoft.AspNetCore.Http;

namespace NeuronMocap.Tool.View.Web;

/// <summary>The JSON between the page and the server: names in camelCase.</summary>
internal static class ApiJson
{
    // Only scripts read the answers, never a parser of HTML, so letters of all alphabets can stay as they are.
    public static JsonSerializerOptions Options { get; } = new(JsonSerializerDefaults.Web) { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    public static byte[] ToBytes<T>(T value) => JsonSerializer.SerializeToUtf8Bytes(value, Options);

    /// <summary>Answers a request with an object.</summary>
    public static Task WriteAsync<T>(HttpContext context, T value, int status = StatusCodes.Status200OK)
    {
        byte[] bytes = ToBytes(value);
        context.Response.StatusCode = status;
        context.Response.ContentType = "application/json; charset=utf-8";
        context.Response.ContentLength = bytes.Length;
        return context.Response.Body.WriteAsync(bytes, context.RequestAborted).AsTask();
    }

    /// <summary>Answers a request with an error.</summary>
    public static Task WriteErrorAsync(HttpContext context, int status, string message) => WriteAsync(context, new ErrorJson(message), status);

    /// <summary>Reads the body of a request.</summary>
    /// <exception cref="ApiException">The body is not an object of this form.</exception>
    public static async Task<T> ReadAsync<T>(HttpContext context)
        where T : class
    {
        try
        {
            return await JsonSerializer.DeserializeAsync<T>(context.Request.Body, Options, context.RequestAborted)
                ?? throw ApiException.BadRequest("The body of the request is empty.");
        }
        catch (JsonException)
        {
            throw ApiException.BadRequest("The body of the request is not the JSON that this address expects.");
        }
    }

    private sealed record ErrorJson(string Error);
}
