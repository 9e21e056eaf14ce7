using System.CommandLine;
using System.CommandLine.Parsing;
using System.Net;
using NeuronMocap.AspNetCore;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.View;

/// <summary>The options of the page and its server.</summary>
internal sealed class ViewArguments
{
    private const int LargestUpload = 100_000;
    private const int LongestToken = 200;

    private readonly Option<int?> _port = new("--port")
    {
        HelpName = "PORT",
        Description = $"Port of the page; 0 for any free one. Default: {ViewOptions.DefaultPort}, or the next free one.",
        CustomParser = static result => NumberArgument.ParseWhole(result, 0, IPEndPoint.MaxPort, $"a number from 0 to {IPEndPoint.MaxPort}"),
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<bool> _open = new("--open") { Description = "Start the browser with the page." };

    private readonly Option<IPAddress?> _bind = CommonOptions.Address(
        "--bind",
        "Address of this computer to listen on; 0.0.0.0 for all. Other computers and phones then need the link with its token, which is shown as text and as a QR "
            + "code. Without TLS the network can read the motion. Default: 127.0.0.1, only this computer.");

    private readonly Option<string?> _token = new("--token")
    {
        HelpName = "WORD",
        Description = "The word that browsers must send, in the link. Default: a new one for every run with --bind; none without it.",
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<string[]> _allowOrigin = new("--allow-origin")
    {
        HelpName = "ORIGIN",
        Description = "For a proxy on this computer that adds TLS: the address under which it shows the page, such as https://show.example; may be repeated. The link "
            + "then has a token.",
        Arity = ArgumentArity.OneOrMore,
    };

    private readonly Option<string?> _recordFolder = new("--record-folder")
    {
        HelpName = "FOLDER",
        Description = "Folder for the recordings that the page starts. It must exist. Default: the current folder.",
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<int?> _upload = new("--upload-limit")
    {
        HelpName = "MB",
        Description = $"Largest take that can be dropped on the page, in megabytes, 1 to {LargestUpload}. Default: {ViewOptions.DefaultUploadMegabytes}.",
        CustomParser = static result => NumberArgument.ParseWhole(result, 1, LargestUpload, $"a whole number of megabytes from 1 to {LargestUpload}"),
        Arity = ArgumentArity.ExactlyOne,
    };

    public Option[] All => [_port, _open, _bind, _token, _allowOrigin, _recordFolder, _upload];

    public ViewOptions Read(ParseResult result, ViewOptions options) => options with
    {
        Port = result.GetValue(_port),
        Open = result.GetValue(_open),
        Bind = result.GetValue(_bind) ?? IPAddress.Loopback,
        Token = result.GetValue(_token),
        AllowedOrigins = result.GetValue(_allowOrigin) ?? [],
        RecordFolder = result.GetValue(_recordFolder),
        UploadMegabytes = result.GetValue(_upload) ?? ViewOptions.DefaultUploadMegabytes,
    };

    public void Reject(CommandResult result, Source source)
    {
        if (source.File is not null && Verb.IsGiven(result, _recordFolder))
            result.AddError("--record-folder needs a stream as the source: a file is shown, and nothing is recorded.");
        if (result.GetResult(_token)?.Tokens is [{ Value: var word }] && !IsToken(word))
            result.AddError($"--token: use letters, digits and -._~ only, at most {LongestToken}, because the word is a part of the link.");
        foreach (Token origin in result.GetResult(_allowOrigin)?.Tokens ?? [])
        {
            if (!AllowedOrigin.IsValid(origin.Value) || !origin.Value.StartsWith("http", StringComparison.OrdinalIgnoreCase))
                result.AddError($"--allow-origin: '{origin.Value}' is not an origin. Use a scheme and a host, such as https://show.example.");
        }
    }

    private static bool IsToken(string word) => word.Length is > 0 and <= LongestToken
        && word.All(static letter => char.IsAsciiLetterOrDigit(letter) || letter is '-' or '.' or '_' or '~');
}
