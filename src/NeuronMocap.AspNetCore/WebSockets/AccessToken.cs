using System.Security.Cryptography;
using System.Text;
using Microsoft.AspNetCore.Http;
using Microsoft.Net.Http.Headers;

namespace NeuronMocap.AspNetCore;

// The word that clients must send, in a header or in the query.
internal static class AccessToken
{
    private const string Bearer = "Bearer ";

    public static bool IsIn(HttpRequest request, string token)
    {
        // Takes the same time for every word, so the time tells nothing of the right one.
        return CryptographicOperations.FixedTimeEquals(SHA256.HashData(Encoding.UTF8.GetBytes(Find(request))), SHA256.HashData(Encoding.UTF8.GetBytes(token)));
    }

    public static bool IsGiven(HttpRequest request) => Find(request).Length > 0;

    private static string Find(HttpRequest request)
    {
        string header = request.Headers[HeaderNames.Authorization].ToString();
        return header.StartsWith(Bearer, StringComparison.OrdinalIgnoreCase) ? header[Bearer.Length..].Trim() : request.Query["token"].ToString();
    }
}
