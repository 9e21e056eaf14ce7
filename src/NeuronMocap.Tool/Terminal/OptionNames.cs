using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Diagnostics;
using NeuronMocap.Recording;
using NeuronMocap.Server;

namespace NeuronMocap.Tool.Terminal;

/// <summary>Replaces names of the library's members in its messages by options of this program.</summary>
/// <remarks>
/// The library's messages name members, but users of the command line know the options of this program. All text of the library passes through here
/// before it is shown. A member without an option gets a plain name.
/// </remarks>
internal static class OptionNames
{
    private static readonly Dictionary<string, string> Names = new(StringComparer.Ordinal)
    {
        [nameof(NeuronReaderOptions.AllowedSenders)] = "--allow-sender",
        [nameof(NeuronReaderOptions.CalculationPort)] = "--calculation-port",
        [nameof(NeuronReaderOptions.CommandPort)] = "--command-port",
        [nameof(NeuronReaderOptions.ConnectTimeout)] = "the connection time-out",
        [nameof(NeuronReaderOptions.LocalAddress)] = "--local-address",
        [nameof(NeuronReaderOptions.LoggerFactory)] = "the log",
        [nameof(NeuronReaderOptions.MaxValues)] = "the limit of values in a packet",
        [nameof(NeuronReaderOptions.ReceiveThread)] = "the thread that receives",
        [nameof(NeuronReaderOptions.RotationOrder)] = "--order",
        [nameof(NeuronReaderOptions.SharePort)] = "the sharing of the port",
        [nameof(NeuronReaderOptions.SilenceTimeout)] = "the silence time-out",
        [nameof(NeuronReaderOptions.SkeletonVariant)] = "the names of the spine's bones",
        [nameof(NeuronReaderOptions.Tls)] = "tls://",
        [$"{nameof(NeuronReaderOptions.Tls)}.{nameof(NeuronTlsOptions.TargetHost)}"] = "--tls-name",
        [$"{nameof(NeuronReaderOptions.Tls)}.{nameof(NeuronTlsOptions.TrustedCertificate)}"] = "--trust",
        [$"{nameof(NeuronReaderOptions.Reconnect)}.{nameof(ReconnectPolicy.Enabled)}"] = "--once",
        [$"{nameof(NeuronReaderOptions.Reconnect)}.{nameof(ReconnectPolicy.InitialDelay)}"] = "the first wait before another attempt",
        [$"{nameof(NeuronReaderOptions.Reconnect)}.{nameof(ReconnectPolicy.MaxDelay)}"] = "the longest wait before another attempt",
        [nameof(ReconnectPolicy.InitialDelay)] = "the first wait before another attempt",
        [nameof(ReconnectPolicy.MaxDelay)] = "the longest wait before another attempt",
        [$"{nameof(NeuronCommandOptions)}.{nameof(NeuronCommandOptions.Timeout)}"] = "the answer time-out",
        [$"{nameof(NeuronCommandOptions)}.{nameof(NeuronCommandOptions.MaxReplySize)}"] = "the limit of a reply",
        [$"{nameof(NeuronCommandOptions)}.{nameof(NeuronCommandOptions.AcceptAnyReplyId)}"] = "the library to accept them",
        [nameof(NeuronCommandOptions.AcceptAnyReplyId)] = "the acceptance of any reply",
        [nameof(NeuronCommandOptions.MaxReplySize)] = "the limit of a reply",
        [nameof(DiagnosisOptions.SearchOtherPorts)] = "the search on other ports",
        [nameof(PlaybackOptions.FrameRate)] = "--rate",
        [nameof(RecordingOptions.FlushInterval)] = "the time between writes",
        [nameof(RecordingOptions.FlushToDisk)] = "the wait for the disk",
        [nameof(RecordingOptions.MaxFileDuration)] = "--record-time",
        [nameof(RecordingOptions.MaxFileSize)] = "--record-size",
        [nameof(RecordingOptions.MaxFiles)] = "--record-files",
        [nameof(RecordingOptions.QueueSize)] = "the size of the write buffer",
        [nameof(BvhExportOptions.AvatarIndex)] = "--export-avatar",
        [nameof(BvhExportOptions.FrameTime)] = "the frame time of the export",
        [nameof(BvhExportOptions.HeaderTimeout)] = "the time-out for the body",
        [nameof(BvhExportOptions.FilePerAvatar)] = "--export-avatar all",
        [nameof(BvhExportOptions.MaxFrames)] = "--frames",
        [nameof(BvhExportOptions.TextFormat)] = "the text format of the export",
        [nameof(BroadcasterOptions.BindAddress)] = "the address of the simulator",
        [nameof(BroadcasterOptions.UdpDestinations)] = "the destinations of the simulator",
    };

    // These names are also English words. They are replaced only in messages about an option that is out of range.
    private static readonly Dictionary<string, string> FaultNames = new(Names, StringComparer.Ordinal)
    {
        [nameof(NeuronReaderOptions.Host)] = "the host of the source",
        [nameof(NeuronReaderOptions.Name)] = "the reader's name",
        [nameof(NeuronReaderOptions.Port)] = "the port of the source",
        [nameof(NeuronReaderOptions.Reconnect)] = "--once",
        [nameof(NeuronReaderOptions.Transport)] = "the source",
        [nameof(ReconnectPolicy.Enabled)] = "--once",
        [nameof(DiagnosisOptions.Timeout)] = "--duration",
        [nameof(DiagnosisOptions.Expected)] = "the kind of frames",
        [nameof(RecordingOptions.Compress)] = "--record-compress",
        [nameof(RecordingOptions.Overwrite)] = "--overwrite",
        [nameof(BvhExportOptions.Body)] = "the body of the export",
        [nameof(BvhExportOptions.Capacity)] = "the size of the write buffer",
        [nameof(BvhExportOptions.GapHandling)] = "the gaps of the export",
    };

    /// <summary>Replaces the names in a message of the library.</summary>
    public static string Translate(string text) => Translate(text, Names);

    /// <summary>Replaces the names in a message of the library about an option that is out of range.</summary>
    public static string Translate(ArgumentException fault)
    {
        // The runtime appends the name of the parameter.
        int parameter = fault.Message.IndexOf(" (Parameter '", StringComparison.Ordinal);
        return Translate(parameter < 0 ? fault.Message : fault.Message[..parameter], FaultNames);
    }

    private static string Translate(string text, Dictionary<string, string> names)
    {
        StringBuilder? translated = null;
        int copied = 0;
        for (int start = 0; start < text.Length;)
        {
            int end = EndOfWord(text, start);
            if (end > start && names.TryGetValue(text[start..end], out string? name))
            {
                translated = (translated ?? new StringBuilder()).Append(text, copied, start - copied).Append(name);
                copied = end;
            }

            start = Math.Max(end, start + 1);
        }

        return translated is null ? text : translated.Append(text, copied, text.Length - copied).ToString();
    }

    // A member's name is one word, or two words with a point between, such as Reconnect.Enabled. A point at the end of a sentence does not belong to
    // it.
    private static int EndOfWord(string text, int start)
    {
        int end = start;
        while (end < text.Length && (IsLetter(text[end]) || (end > start && text[end] == '.' && end + 1 < text.Length && IsLetter(text[end + 1]))))
            end++;

        return end;
    }

    private static bool IsLetter(char letter) => char.IsLetterOrDigit(letter) || letter == '_';
}
