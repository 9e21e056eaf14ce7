using NeuronMocap.Protocol;
using NeuronMocap.Transport;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Monitor.Terminal;

/// <summary>In place of the skeleton when there is none to show: why, in a box that cannot be missed.</summary>
internal static class ProblemView
{
    private const int WidestText = 76;

    public static IRenderable Create(LiveState state, int width)
    {
        (string title, string message, Color color) = Explain(state);
        var text = new Rows(
            new Text(title, new Style(color, decoration: Decoration.Bold)).Centered(),
            Text.Empty,
            new Text(TerminalText.Clean(message)).Centered(),
            Text.Empty,
            new Text(HeaderView.DescribeRetry(state.Status, state.Now), new Style(Palette.Warning)).Centered());
        Panel panel = new Panel(text).Border(BoxBorder.Heavy).BorderColor(color).Padding(2, 0);
        panel.Width = Math.Min(width, WidestText);
        return Align.Center(panel, VerticalAlignment.Middle);
    }

    private static (string Title, string Message, Color Color) Explain(LiveState state)
    {
        ConnectionStatus status = state.Status;
        if (status.State != ConnectionState.Receiving)
            return (TitleOf(status), status.Message, Palette.Of(status.State));
        if (state.Pose is { HasSkeleton: false } pose)
        {
            return (
                "FRAMES WITHOUT A SKELETON",
                $"A frame carries {pose.Header.ValueCount} values; the 59 bones have 180, 186, 354 or 360. --json shows the values.",
                Palette.Warning);
        }

        bool hasCalculation = state.Counters.Avatars.Any(avatar => avatar.Kind is PacketKind.Calculation or PacketKind.StudioCalculation);
        return hasCalculation
            ? (
                "CALCULATION DATA ONLY",
                "The skeleton is drawn from BVH data. In the server's broadcasting settings, switch BVH on for this port.",
                Palette.Warning)
            : ("RECEIVING", "The first frame is on its way.", Palette.Of(ConnectionState.Receiving));
    }

    private static string TitleOf(ConnectionStatus status) => (status.State, status.Reason) switch
    {
        (ConnectionState.Connected, _) => "CONNECTED, WAITING FOR FRAMES",
        (ConnectionState.Connecting or ConnectionState.Created, _) => "CONNECTING",
        (ConnectionState.Silent, ConnectionReason.UnknownFormat) => "DATA ARRIVES, BUT NO FRAMES",
        (ConnectionState.Silent, ConnectionReason.SenderNotAllowed) => "SENDER NOT ALLOWED",
        (ConnectionState.Silent, _) => "NOTHING ARRIVES",
        (_, ConnectionReason.Refused) => "CONNECTION REFUSED",
        (_, ConnectionReason.TimedOut) => "NO ANSWER",
        (_, ConnectionReason.HostNotFound) => "HOST NOT FOUND",
        (_, ConnectionReason.Unreachable) => "NO ROUTE",
        (_, ConnectionReason.Reset or ConnectionReason.ClosedByPeer) => "CONNECTION CLOSED",
        (_, ConnectionReason.PortInUse) => "PORT IN USE",
        (_, ConnectionReason.AddressUnavailable or ConnectionReason.AccessDenied) => "NOT ALLOWED",
        (_, ConnectionReason.EndOfRecording) => "END OF THE RECORDING",
        (ConnectionState.Stopped, _) => "STOPPED",
        _ => "NO CONNECTION",
    };
}
