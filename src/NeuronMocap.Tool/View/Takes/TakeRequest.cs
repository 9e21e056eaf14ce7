using System.Globalization;
using Microsoft.AspNetCore.Http;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>The values in the address of a request about a take.</summary>
internal static class TakeRequest
{
    private const double Microseconds = 1000; // in a millisecond

    /// <summary>Gets a whole number.</summary>
    /// <exception cref="ApiException">The value is not a number of this range.</exception>
    public static long GetNumber(HttpContext context, string name, long usual, long least, long most)
    {
        string text = context.Request.Query[name].ToString();
        if (text.Length == 0)
            return usual;

        return long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long value) && value >= least && value <= most
            ? value
            : throw ApiException.BadRequest($"{name} must be a whole number from {least} to {most}.");
    }

    /// <summary>Gets a time.</summary>
    /// <returns>Microseconds.</returns>
    /// <exception cref="ApiException">The value is not a time in milliseconds.</exception>
    public static long GetTime(HttpContext context, string name, long usual)
    {
        const double Longest = 1e12; // ms

        string text = context.Request.Query[name].ToString();
        if (text.Length == 0)
            return usual;

        return double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && Math.Abs(value) < Longest
            ? (long)(value * Microseconds)
            : throw ApiException.BadRequest($"{name} must be a time in milliseconds.");
    }

    /// <summary>Gets one of the names of an enumeration.</summary>
    /// <exception cref="ApiException">The value is not such a name.</exception>
    public static T GetName<T>(HttpContext context, string name)
        where T : struct, Enum
    {
        string text = context.Request.Query[name].ToString();
        return Enum.TryParse(text, ignoreCase: true, out T value) && Enum.IsDefined(value) && !char.IsAsciiDigit(text[0])
            ? value
            : throw ApiException.BadRequest($"{name} must be one of these: {string.Join(", ", Enum.GetNames<T>()).ToLowerInvariant()}.");
    }
}
