namespace NeuronMocap.AspNetCore;

/// <summary>Options of a <see cref="WebSocketBroadcaster"/>, which copies them.</summary>
public sealed class WebSocketBroadcasterOptions
{
    /// <summary>
    /// A word that every client must send: in the header <c>Authorization: Bearer WORD</c>, or in the query as <c>?token=WORD</c>. Null, the default, for none.
    /// In the query, special characters are percent-encoded. Spaces around the word are refused. Without TLS, the network can read it.
    /// </summary>
    public string? Token { get; set; }

    /// <summary>
    /// The web sites whose pages may connect, such as <c>https://show.example</c>. A page from a file has the origin <c>null</c>; <c>*</c> allows every page.
    /// A port that the scheme implies can be left out.
    /// </summary>
    /// <remarks>
    /// Pages of this computer, such as those of <c>http://localhost:8080</c>, may always connect. Without this check, any page that a browser on this
    /// computer shows could read the motion. Programs other than browsers send no origin and are not affected.
    /// </remarks>
    public IReadOnlyList<string> AllowedOrigins { get; set; } = [];

    /// <summary>Largest number of clients, 1 to 100,000. The default is 100. Further clients get the status 503.</summary>
    public int MaxClients { get; set; } = 100;

    /// <summary>
    /// Largest number of frames per second for each avatar and client: 0, or 0.01 to 1000. With 0, the default, clients get every frame that they can take. A client
    /// chooses a lower rate by its query, as in <c>?rate=30</c>.
    /// </summary>
    public double MaxRate { get; set; }

    /// <summary>
    /// Longest time for one message to be sent: 0.1 s to an hour. The default is 10 s. A client that does not read loses frames meanwhile, and is
    /// disconnected then.
    /// </summary>
    public TimeSpan ClientTimeout { get; set; } = TimeSpan.FromSeconds(10);

    internal WebSocketBroadcasterOptions CopyChecked(string parameter)
    {
        var copy = (WebSocketBroadcasterOptions)MemberwiseClone();
        copy.AllowedOrigins = [.. AllowedOrigins ?? []];
        return copy.FindFault() is { } fault ? throw new ArgumentException(fault, parameter) : copy;
    }

    private string? FindFault()
    {
        if (Token is not null && (Token.Length == 0 || Token.Any(char.IsControl)))
            return "Token is empty or has a line break; set a word, or leave it null.";
        if (Token is not null && Token.Trim().Length < Token.Length)
            return "Token has spaces at its start or end, which a header does not carry; remove them.";
        if (AllowedOrigins.Any(static origin => origin is null))
            return "AllowedOrigins contains a null reference; remove it. Write \"null\" for pages from files.";
        if (AllowedOrigins.FirstOrDefault(static origin => !AllowedOrigin.IsValid(origin)) is { } wrong)
            return $"AllowedOrigins contains '{wrong}'; an origin is a scheme and a host, such as https://show.example, or null, or *.";
        if (MaxClients is < 1 or > 100_000)
            return $"MaxClients is {MaxClients}; it must be 1 to 100,000.";
        if (MaxRate != 0 && MaxRate is not (>= 0.01 and <= 1000))
            return FormattableString.Invariant($"MaxRate is {MaxRate}; it must be 0, or 0.01 to 1000.");

        return ClientTimeout < TimeSpan.FromSeconds(0.1) || ClientTimeout > TimeSpan.FromHours(1)
            ? $"ClientTimeout is {ClientTimeout}; it must be 0.1 s to 1 hour."
            : null;
    }
}
