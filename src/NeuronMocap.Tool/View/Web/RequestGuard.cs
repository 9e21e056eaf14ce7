using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Http.Metadata;
using Microsoft.Net.Http.Headers;

namespace NeuronMocap.Tool.View.Web;

/// <summary>What every request passes: security headers, access, and errors as JSON.</summary>
internal static class RequestGuard
{
    /// <summary>The largest body of a request without a limit of its own, in bytes.</summary>
    public const long UsualBody = 64 * 1024;

    // The page brings all it needs. Pictures of dropped characters are blobs of the page itself.
    private const string ContentPolicy = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; font-src 'self'; "
        + "connect-src 'self' blob: data:; worker-src 'self' blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

    /// <summary>Adds the checks before the addresses of the application.</summary>
    public static void UseGuard(this IApplicationBuilder application, AccessPolicy policy)
    {
        application.Use((context, next) => HandleAsync(context, next, policy));
    }

    private static async Task HandleAsync(HttpContext context, RequestDelegate next, AccessPolicy policy)
    {
        AddHeaders(context.Response.Headers, AccessPolicy.IsOfThisComputer(context.Request.Host));
        if (policy.FindRefusal(context.Request) is var (status, reason))
        {
            if (status == StatusCodes.Status401Unauthorized)
                context.Response.Headers.WWWAuthenticate = "Bearer";

            await ApiJson.WriteErrorAsync(context, status, reason);
            return;
        }

        try
        {
            await next(context);
            if (!context.Response.HasStarted && DescribeEmpty(context.Response.StatusCode) is { } sentence)
                await ApiJson.WriteErrorAsync(context, context.Response.StatusCode, sentence);
        }
        catch (ApiException exception) when (!context.Response.HasStarted)
        {
            await ApiJson.WriteErrorAsync(context, exception.Status, exception.Message);
        }
        catch (BadHttpRequestException exception) when (!context.Response.HasStarted)
        {
            await ApiJson.WriteErrorAsync(context, exception.StatusCode, Describe(exception, context));
        }
        catch (OperationCanceledException) when (context.RequestAborted.IsCancellationRequested)
        {
            // The browser does not want the answer any more.
        }
    }

    private static void AddHeaders(IHeaderDictionary headers, bool isTrustworthy)
    {
        headers[HeaderNames.ContentSecurityPolicy] = ContentPolicy;
        headers[HeaderNames.XContentTypeOptions] = "nosniff";
        headers["Referrer-Policy"] = "no-referrer";
        headers["Cross-Origin-Resource-Policy"] = "same-origin";
        headers[HeaderNames.CacheControl] = "no-store";

        // On pages of other computers without TLS, browsers ignore it and report an error.
        if (isTrustworthy)
            headers["Cross-Origin-Opener-Policy"] = "same-origin";
    }

    // The routing answers these itself, without words.
    private static string? DescribeEmpty(int status) => status switch
    {
        StatusCodes.Status404NotFound => "There is nothing at this address.",
        StatusCodes.Status405MethodNotAllowed => "This address does not know the method of the request.",
        _ => null,
    };

    private static string Describe(BadHttpRequestException exception, HttpContext context)
    {
        if (exception.StatusCode != StatusCodes.Status413PayloadTooLarge)
            return "The request is not complete.";

        long most = context.GetEndpoint()?.Metadata.GetMetadata<IRequestSizeLimitMetadata>()?.MaxRequestBodySize ?? UsualBody;
        return most >= BodyLimit.Megabyte ? $"The file is larger than {most / BodyLimit.Megabyte} MB." : $"The body of the request is larger than {most / 1024} kB.";
    }
}

/// <summary>The largest body of a request to an address: <c>WithMetadata(new BodyLimit(bytes))</c>.</summary>
/// <param name="bytes">Bytes.</param>
internal sealed class BodyLimit(long bytes) : IRequestSizeLimitMetadata
{
    public const long Megabyte = 1024 * 1024;

    public long? MaxRequestBodySize => bytes;
}
