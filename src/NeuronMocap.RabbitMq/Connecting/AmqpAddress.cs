using System.Text;

namespace NeuronMocap.RabbitMq.Connecting;

// The text form of options: amqp://USER:PASSWORD@HOST:PORT/VHOST?NAME=VALUE&NAME=VALUE. No message repeats a password.
internal static class AmqpAddress
{
    public const string Scheme = "amqp://";

    private const string Form = "amqp://USER:PASSWORD@HOST:PORT/VHOST?stage=NAME";

    // set: takes a name and a value of the query. Returns false if the name is unknown.
    public static void Read(string text, RabbitMqOptions options, string names, Func<string, string, bool> set)
    {
        string word = text.Trim();
        if (!word.StartsWith(Scheme, StringComparison.OrdinalIgnoreCase) || !Uri.TryCreate(word, UriKind.Absolute, out Uri? address) || address.Host.Length == 0)
            throw new FormatException($"'{Redact(word)}' is not the address of a broker. Use {Form}.");

        // A password with '/' or '?' ends the host too early. The rest of it would be shown as a virtual host or a name.
        if (word.LastIndexOf('@') > address.GetLeftPart(UriPartial.Authority).Length)
            throw new FormatException($"'{Redact(word)}' has an '@' behind its host. In names and passwords, write %2F for '/', %3F for '?' and %40 for '@'.");

        options.Host = address.DnsSafeHost;
        options.Port = address.Port switch
        {
            -1 => RabbitMqOptions.DefaultPort,
            0 => throw new FormatException($"'{Redact(word)}' has port 0. A broker's port is 1 to 65535, usually {RabbitMqOptions.DefaultPort}."),
            int port => port,
        };
        ReadUser(address.UserInfo, options);
        ReadVirtualHost(address.AbsolutePath, word, options);
        if (address.Fragment.Length > 0)
            throw new FormatException($"'{Redact(word)}' contains '#'. Write %23 in names and passwords.");

        foreach (string part in address.Query.TrimStart('?').Split(['&'], StringSplitOptions.RemoveEmptyEntries))
        {
            int equals = part.IndexOf('=');
            string name = equals < 0 ? part : part.Substring(0, equals);
            string value = equals < 0 ? string.Empty : Uri.UnescapeDataString(part.Substring(equals + 1));
            if (value.Length == 0)
                throw new FormatException($"'{name}' in '{Redact(word)}' has no value. Use {name}=VALUE.");
            if (!set(name, value))
                throw new FormatException($"'{Redact(word)}' has an unknown part '{name}'. After '?', use {names}.");
        }
    }

    public static string Format(RabbitMqOptions options)
    {
        var text = new StringBuilder(Scheme);
        text.Append(EndPoint(options)).Append('/');
        if (!string.Equals(options.VirtualHost, "/", StringComparison.Ordinal))
            text.Append(Uri.EscapeDataString(options.VirtualHost));

        char separator = '?';
        foreach ((string name, string? value) in options.Parameters)
        {
            if (value is null)
                continue;

            text.Append(separator).Append(name).Append('=').Append(Uri.EscapeDataString(value));
            separator = '&';
        }

        return text.ToString();
    }

    public static string EndPoint(RabbitMqOptions options) =>
        options.Host.Contains(':') ? $"[{options.Host}]:{options.Port}" : $"{options.Host}:{options.Port}";

    // Everything before the last '@' may be a password, also in a text that is no address. If the host is missing, it is behind a colon.
    private static string Redact(string text)
    {
        int at = text.LastIndexOf('@');
        if (at >= 0)
            return $"{Scheme}...{text.Substring(at)}";

        int start = text.IndexOf("://", StringComparison.Ordinal);
        int colon = start < 0 ? -1 : text.IndexOf(':', start + 1);
        return colon < 0 || IsPort(text, colon + 1) ? text : $"{text.Substring(0, colon)}:...";
    }

    private static bool IsPort(string text, int start)
    {
        int end = start;
        while (end < text.Length && text[end] is >= '0' and <= '9')
            end++;

        return end == text.Length || text[end] is '/' or '?';
    }

    private static void ReadUser(string info, RabbitMqOptions options)
    {
        if (info.Length == 0)
            return;

        int colon = info.IndexOf(':');
        options.UserName = Uri.UnescapeDataString(colon < 0 ? info : info.Substring(0, colon));
        if (colon >= 0)
            options.Password = Uri.UnescapeDataString(info.Substring(colon + 1));
    }

    private static void ReadVirtualHost(string path, string word, RabbitMqOptions options)
    {
        string name = path.TrimStart('/');
        if (name.Length == 0)
            return;
        if (name.Contains('/'))
            throw new FormatException($"'{Redact(word)}' has a '/' in its virtual host. Write %2F instead.");

        options.VirtualHost = Uri.UnescapeDataString(name);
    }
}
