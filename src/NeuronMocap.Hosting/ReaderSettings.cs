using System.Globalization;
using System.Net;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.Options;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Hosting;

// Reads options from a configuration section. The general binder is unsuitable: it silently ignores misspelt keys and addresses, reads "5" as five
// days, and needs reflection.
internal static class ReaderSettings
{
    private const string AllowedSenders = "AllowedSenders";
    private const string TlsEnabled = "Tls:Enabled";
    private const string TrustedCertificate = "Tls:TrustedCertificate";

    private static readonly Dictionary<string, Action<NeuronReaderOptions, string>> Settings = new(StringComparer.OrdinalIgnoreCase)
    {
        ["Name"] = static (options, text) => options.Name = text,
        ["Transport"] = static (options, text) => options.Transport = Word<TransportKind>(text),
        ["Host"] = static (options, text) => options.Host = text,
        ["Port"] = static (options, text) => options.Port = Number(text),
        ["LocalAddress"] = static (options, text) => options.LocalAddress = Address(text),
        ["SharePort"] = static (options, text) => options.SharePort = Switch(text),
        [AllowedSenders] = static (options, text) => options.AllowedSenders = [.. options.AllowedSenders, .. Parts(text).Select(Address)],
        ["ConnectTimeout"] = static (options, text) => options.ConnectTimeout = Time(text),
        ["ReceiveThread"] = static (options, text) => options.ReceiveThread = Word<ReceiveThread>(text),
        ["SilenceTimeout"] = static (options, text) => options.SilenceTimeout = Time(text),
        ["Reconnect:Enabled"] = static (options, text) => options.Reconnect.Enabled = Switch(text),
        ["Reconnect:InitialDelay"] = static (options, text) => options.Reconnect.InitialDelay = Time(text),
        ["Reconnect:MaxDelay"] = static (options, text) => options.Reconnect.MaxDelay = Time(text),
        ["RotationOrder"] = static (options, text) => options.RotationOrder = Word<RotationOrder>(text),
        ["SkeletonVariant"] = static (options, text) => options.SkeletonVariant = Word<SkeletonVariant>(text),
        ["CommandPort"] = static (options, text) => options.CommandPort = Number(text),
        ["CalculationPort"] = static (options, text) => options.CalculationPort = Number(text),
        ["MaxValues"] = static (options, text) => options.MaxValues = Number(text),
        [TlsEnabled] = static (options, text) => options.Tls = Switch(text) ? options.Tls ?? new() : null,
        ["Tls:TargetHost"] = static (options, text) => (options.Tls ??= new()).TargetHost = text,
        [TrustedCertificate] = static (options, text) => (options.Tls ??= new()).TrustedCertificate = Certificate(text),
    };

    // Options that can be null. Before .NET 10, a null in JSON becomes an empty text.
    private static readonly HashSet<string> Optional = new(StringComparer.OrdinalIgnoreCase)
    {
        "Name", "LocalAddress", "RotationOrder", "SkeletonVariant", "CommandPort", "CalculationPort", "Tls:TargetHost", TrustedCertificate,
    };

    public static IEnumerable<string> Keys => Settings.Keys;

    // folder: where relative paths begin.
    public static void Apply(IConfigurationSection section, string name, string folder, NeuronReaderOptions options)
    {
        List<string> faults = [];
        List<string> senders = [];

        // An array in a file and a list in the environment are two keys. The list replaces the array, so that it can restrict the senders. An empty
        // list does not replace it, because that would allow all senders.
        bool hasList = section[AllowedSenders] is { } list && !IsEmptyList(list);
        foreach ((string key, string? text) in section.AsEnumerable(makePathsRelative: true))
        {
            // Before .NET 10, an empty array in a file is a key without a text. So is the key above the items of an array.
            if (IsKey(WithoutIndex(key), AllowedSenders))
                senders.Add(text ?? string.Empty);

            if (text is null || (text.Length == 0 && Optional.Contains(key)) || key.Length == 0 || (hasList && IsArrayItem(key)))
                continue;

            if (Find(key, IsKey(key, TrustedCertificate) ? Path.Combine(folder, text) : text, options) is { } fault)
                faults.Add(Prefix(name) + fault);
        }

        // The other settings of TLS may come after the one that turns it off.
        if (bool.TryParse(section[TlsEnabled], out bool isEncrypted) && !isEncrypted)
            options.Tls = null;

        if (senders.Count > 0 && senders.TrueForAll(IsEmptyList))
            faults.Add($"{Prefix(name)}{AllowedSenders} is empty; leave it out to allow all senders.");

        if (faults.Count > 0)
            throw new OptionsValidationException(name, typeof(NeuronReaderOptions), faults);
    }

    public static string Prefix(string? name) => string.IsNullOrEmpty(name) ? string.Empty : $"{name}: ";

    private static string? Find(string key, string text, NeuronReaderOptions options)
    {
        if (!Settings.TryGetValue(WithoutIndex(key), out Action<NeuronReaderOptions, string>? set))
            return $"{key} is not a setting of a reader; use one of {string.Join(", ", Keys)}.";

        try
        {
            set(options, text);
            return null;
        }
        catch (FormatException exception)
        {
            return $"{key} is '{text}'; it must be {exception.Message}.";
        }
    }

    private static T Word<T>(string text)
        where T : struct, Enum =>
        Enum.TryParse(text, ignoreCase: true, out T value) && Array.Exists(Enum.GetNames<T>(), name => name.Equals(text, StringComparison.OrdinalIgnoreCase))
            ? value
            : throw new FormatException($"one of {string.Join(", ", Enum.GetNames<T>())}");

    private static int Number(string text) =>
        int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int number) ? number : throw new FormatException("a whole number");

    private static bool Switch(string text) => bool.TryParse(text, out bool on) ? on : throw new FormatException("true or false");

    private static string WithoutIndex(string key) => IsArrayItem(key) ? AllowedSenders : key;

    private static bool IsKey(string key, string other) => key.Equals(other, StringComparison.OrdinalIgnoreCase);

    // An array in JSON has a key for each item.
    private static bool IsArrayItem(string key) => key.StartsWith(AllowedSenders + ":", StringComparison.OrdinalIgnoreCase);

    private static string[] Parts(string text) => text.Split(',', StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries);

    private static bool IsEmptyList(string text) => Parts(text).Length == 0;

    private static X509Certificate2 Certificate(string file)
    {
        if (!File.Exists(file))
            throw new FormatException("a file that exists");

        try
        {
            return new X509Certificate2(file);
        }
        catch (UnauthorizedAccessException exception)
        {
            throw new FormatException("a file that this program may read", exception);
        }
        catch (Exception exception) when (exception is CryptographicException or IOException)
        {
            throw new FormatException("a file that holds a certificate in PEM or DER form", exception);
        }
    }

    private static IPAddress Address(string text) =>
        IPAddress.TryParse(text, out IPAddress? address) ? address : throw new FormatException("an IP address");

    // Accepts "00:00:05", the format of TimeSpan, or "5" for seconds. A plain number never means days, because days are too long to wait for a frame.
    private static TimeSpan Time(string text)
    {
        if (double.TryParse(text, NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double seconds)
            && Math.Abs(seconds) < TimeSpan.MaxValue.TotalSeconds)
        {
            return TimeSpan.FromSeconds(seconds);
        }

        return TimeSpan.TryParse(text, CultureInfo.InvariantCulture, out TimeSpan time)
            ? time
            : throw new FormatException("a time: hours:minutes:seconds, or a number of seconds");
    }
}
