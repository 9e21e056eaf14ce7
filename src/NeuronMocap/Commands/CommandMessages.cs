using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Commands;

// The messages that tell a person why a command failed and which setting to check.
internal static class CommandMessages
{
    private const string WhichPort =
        "Check the command port: on the server it is a separate setting, not the port of the stream.";

    public static NeuronCommandException NotConnected(ConnectionReason reason, LinkOptions link, Exception? cause) => reason switch
    {
        ConnectionReason.HostNotFound => new(CommandFailure.HostNotFound, ConnectionMessages.HostNotFound(link.Host), cause),
        ConnectionReason.Refused => new(
            CommandFailure.Refused, $"{link.Target} refused the connection: nothing listens there. {WhichPort}", cause),
        ConnectionReason.TimedOut => new(
            CommandFailure.NotConnected,
            $"{link.Target} did not answer within {ConnectionMessages.Seconds(link.ConnectTimeout)}. Check the address, that both computers are on the same network, and that "
            + "no firewall blocks the port.",
            cause),
        ConnectionReason.AccessDenied or ConnectionReason.Unreachable or ConnectionReason.AddressUnavailable => new(
            CommandFailure.NotConnected, ConnectionMessages.TcpFailed(reason, link, cause!), cause),
        _ => new(CommandFailure.NotConnected, $"The connection to {link.Target} failed: {cause?.Message}", cause),
    };

    public static NeuronCommandException ResolverTimedOut(LinkOptions link) =>
        new(CommandFailure.NotConnected, ConnectionMessages.ResolverTimedOut(link));

    public static NeuronCommandException TimedOut(string target, NeuronCommandOptions options, long skipped, bool isIncomplete)
    {
        string what = (isIncomplete, skipped) switch
        {
            (true, _) => "The reply was not complete within",
            (_, > 0) => $"{CountedNoun.Of(skipped, "byte")} came, but no reply, within",
            _ => "No reply came within",
        };
        string check = skipped > 0 ? WhichPort : WhichPort + " For a slow server, raise NeuronCommandOptions.Timeout.";
        return new(CommandFailure.TimedOut, $"{target}: {what} {ConnectionMessages.Seconds(options.Timeout)}. {check}");
    }

    public static NeuronCommandException Closed(string target, bool isIncomplete, Exception? cause) => new(
        CommandFailure.Closed,
        $"{target} closed the connection {(isIncomplete ? "in the middle of the reply" : "without an answer")}. {WhichPort}",
        cause);

    public static NeuronCommandException SpokeFirst(string target) => new(
        CommandFailure.InvalidReply, $"{target} sent data before the first request, which a command port never does. {WhichPort}");

    public static NeuronCommandException WrongSize(string target, int size, NeuronCommandOptions options) => new(
        CommandFailure.InvalidReply,
        size < 0
            ? $"{target} announced a reply of {CountedNoun.Of(size, "byte")}."
            : $"{target} announced a reply of {CountedNoun.Of(size, "byte")}; NeuronCommandOptions.MaxReplySize allows {options.MaxReplySize}.");

    public static NeuronCommandException WrongId(string target, CommandChannelId asked, int id) => new(
        CommandFailure.InvalidReply,
        $"{target} answered command {(int)asked} with number {id}. If this server's answers are nevertheless correct, set "
        + "NeuronCommandOptions.AcceptAnyReplyId.");

    public static NeuronCommandException InvalidReply(string target, string what, Exception? cause = null) =>
        new(CommandFailure.InvalidReply, $"{target}: {what}", cause);

    public static NeuronCommandException NoAnswer(string target, int? avatar) => new(
        CommandFailure.Rejected,
        $"{target} has no answer{(avatar is { } index ? $" for avatar {index}: there may be no such avatar" : string.Empty)}.");

    public static NeuronCommandException NotZeroedOut(string target, int? avatar) => new(
        CommandFailure.Rejected,
        avatar is { } index
            ? $"{target} did not zero out avatar {index}: there may be no such avatar, or no suit connected."
            : $"{target} did not zero out the avatars: there may be none, or no suit connected.");
}
