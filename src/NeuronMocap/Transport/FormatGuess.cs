using System.Text;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

internal enum ForeignFormat
{
    Unknown,
    UnknownVersion,
    TooManyValues,
    Incomplete,
    Text,
    AmbiguousName,
    MissingAvatar,
    AdvancedBvh,
    CommandReply,
    Motion,
    OtherProgram,
}

// A guess at the format of bytes that are not packets, and at the setting that would make them packets. Text completes a sentence that begins with "it
// is".
internal readonly record struct FormatGuess(ForeignFormat Format, string Text, string Advice)
{
    // How streams of other programs begin, or their answers to a client that speaks first: the first bytes, and the name for the message.
    private static readonly (string Start, string Name)[] OtherPrograms =
    [
        ("HTTP/", "a web server's answer"),
        ("<", "a web page"),
        ("SSH-", "the greeting of an SSH server"),
        ("220 ", "the greeting of a mail or FTP server"),
        ("220-", "the greeting of a mail or FTP server"),
        ("RFB ", "the greeting of a VNC server"),
        ("RTSP/", "the answer of a video server (RTSP)"),
        ("\u0015\u0003", "an encrypted connection's error message (TLS)"),
        ("\u0016\u0003", "the start of an encrypted connection (TLS)"),
        ("#bundle", "OSC, which other motion capture programs send"),
        ("/", "OSC, which other motion capture programs send"),
        ("MXTP", "the stream of Xsens MVN"),
        ("{", "JSON text of another program"),
    ];

    public string Description => $"{Text}. {Advice}";

    public static FormatGuess Of(ReadOnlySpan<byte> start, SkipReason reason)
    {
        if (reason == SkipReason.UnknownVersion && start.Length >= 6)
        {
            return new(
                ForeignFormat.UnknownVersion,
                $"of data version {DataVersion.Read(start[2..])}, which this reader does not support: it reads only 1.0 and 1.1",
                "Look for a newer version of this library, or for an older format in the server's broadcasting settings.");
        }

        if (reason == SkipReason.TooLarge)
            return new(ForeignFormat.TooManyValues, "a packet that announces more values than the limit allows", "If that is correct, raise MaxValues.");
        if (reason == SkipReason.NotCalculation)
        {
            return new(
                ForeignFormat.Motion,
                "motion data, which does not belong on this port of calculation data",
                "Set CalculationPort to the port on which the server broadcasts calculation data, usually 7003, or leave it out.");
        }

        if (reason == SkipReason.Incomplete)
        {
            return new(
                ForeignFormat.Incomplete, "only the first part of each packet; the rest is lost on the way", "Check the firewall, or use TCP.");
        }

        if (start.Length >= 2 && start[0] == ProtocolConstants.TokenStart && start[1] == ProtocolConstants.CommandToken1)
        {
            return new(
                ForeignFormat.CommandReply, "a reply to a command", "This is the command port; data is broadcast on another port, by default 7001.");
        }

        if (reason == SkipReason.AmbiguousName)
        {
            return new(
                ForeignFormat.AmbiguousName,
                "text, but with too many words: the avatar's name has spaces and numbers, which cannot be distinguished from the values",
                "Rename the avatar on the server, without spaces. If its name has none, set Skeleton to \"Axis Studio\"; or set the format (block type) to Binary.");
        }

        if (reason == SkipReason.MissingAvatar)
            return MissingAvatar("text, but its lines contain the values of a frame without the avatar's number and name before them");
        if (IsAdvancedBvh(start))
        {
            return new(
                ForeignFormat.AdvancedBvh,
                "Axis Studio's \"Advanced BVH\", a compressed stream for Maya and MotionBuilder that this reader does not support",
                "In Axis Studio open Settings > BVH Broadcasting, switch that on, and connect to its port (usually 7001). Advanced BVH has a different port, usually 7007.");
        }

        // Check for numbers first: the text format can begin with any number, also with one that begins a greeting.
        return OfText(start, reason) ?? OfProgram(start)
            ?? (NumericText.BeginsWithName(start) ? MissingAvatar("text, but its lines begin with a word instead of the avatar's number") : Unknown(start));
    }

    public static string ToHex(ReadOnlySpan<byte> bytes)
    {
        var text = new StringBuilder(bytes.Length * 3);
        foreach (byte value in bytes[..Math.Min(bytes.Length, 8)])
            text.Append(text.Length > 0 ? " " : string.Empty).Append(value.ToString("X2", provider: null));

        return text.ToString();
    }

    private static FormatGuess MissingAvatar(string text) => new(
        ForeignFormat.MissingAvatar,
        text,
        "A line must begin with the avatar's number and name, as in \"0 Char00 0.00 93.02\". Make the sender write them, or set the format (block type) to Binary.");

    // Four letters C, the length, and then the first bytes of gzip.
    private static bool IsAdvancedBvh(ReadOnlySpan<byte> start) =>
        start.Length >= 10 && start.StartsWith("CCCC"u8) && start[8] == 0x1F && start[9] == 0x8B;

    private static FormatGuess? OfProgram(ReadOnlySpan<byte> start)
    {
        foreach ((string beginning, string name) in OtherPrograms)
        {
            if (StartsWith(start, beginning))
                return new(ForeignFormat.OtherProgram, name, "Check the port against the one in the server's broadcasting settings; it is usually 7001.");
        }

        return null;
    }

    private static FormatGuess? OfText(ReadOnlySpan<byte> start, SkipReason reason) => reason == SkipReason.MalformedLine || NumericText.IsAt(start)
        ? new(
            ForeignFormat.Text,
            "text, but no line contains the values of the 59 bones (180, 186, 354 or 360 of motion, 338 or 946 of calculation data)",
            "In Axis Studio's BVH broadcasting settings set Skeleton to \"Axis Studio\", or set the format (block type) to Binary.")
        : null;

    private static FormatGuess Unknown(ReadOnlySpan<byte> start) => new(
        ForeignFormat.Unknown,
        $"of no known format; it starts with {ToHex(start)}",
        "Check the port against the one in the server's broadcasting settings; it is usually 7001.");

    private static bool StartsWith(ReadOnlySpan<byte> bytes, string beginning)
    {
        if (bytes.Length < beginning.Length)
            return false;

        for (int i = 0; i < beginning.Length; i++)
        {
            if (bytes[i] != beginning[i])
                return false;
        }

        return true;
    }
}
