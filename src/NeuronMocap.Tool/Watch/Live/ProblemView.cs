using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>In place of the skeleton when there is none to show: why, in a box that cannot be missed.</summary>
internal static class ProblemView
{
    private const int WidestText = 76;
    private const int BorderWidth = 6;
    private const int BorderHeight = 2;

    // Title, retry and the empty lines between.
    private const int LinesBesides = 4;

    /// <summary>Makes the box; in a low window it gives up its empty lines, and then its border.</summary>
    /// <param name="problem">What <see cref="Find"/> found.</param>
    /// <param name="state">What the view shows.</param>
    /// <param name="width">Columns that there are.</param>
    /// <param name="height">Lines that there are.</param>
    public static IRenderable Create(in Problem problem, LiveState state, int width, int height)
    {
        int outer = Math.Min(width, WidestText);
        string retry = HeaderView.DescribeRetry(state.Status, state.Now);
        IReadOnlyList<string> lines = WrappedText.Break(problem.Message, outer - BorderWidth, int.MaxValue);
        bool isFramed = lines.Count + LinesBesides + BorderHeight <= height;
        if (!isFramed)
            lines = WrappedText.Break(problem.Message, width, Math.Max(height - (retry.Length > 0 ? 2 : 1), 1));

        var rows = new List<IRenderable> { new Text(problem.Title, new Style(problem.Color, decoration: Decoration.Bold)).Centered() };
        if (isFramed)
            rows.Add(Text.Empty);

        rows.AddRange(lines.Select(static line => new Text(line).Centered()));
        if (isFramed)
            rows.Add(Text.Empty);
        if (isFramed || retry.Length > 0)
            rows.Add(new Text(retry, new Style(Palette.Warning)).Centered());
        if (!isFramed)
            return new Rows(rows);

        Panel panel = new Panel(new Rows(rows)).Border(BoxBorder.Heavy).BorderColor(problem.Color).Padding(2, 0);
        panel.Width = outer;
        return Align.Center(panel, VerticalAlignment.Middle);
    }

    /// <summary>Finds why there is no skeleton to show, or what is wrong with the one that is shown.</summary>
    /// <returns>Null when there is nothing to say.</returns>
    public static Problem? Find(LiveState state)
    {
        ConnectionStatus status = state.Status;
        if (status.State != ConnectionState.Receiving)
            return new(TitleOf(status), status.Describe(), Palette.Of(status.State));
        if (state.Pose is { HasSkeleton: true })
            return status.Reason == ConnectionReason.None ? null : new("RECEIVING", status.Describe(), Palette.Warning);

        (string title, string message, Color color) = Explain(state);
        return new(title, message, color);
    }

    private static (string Title, string Message, Color Color) Explain(LiveState state)
    {
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

/// <summary>What is wrong, and what to do.</summary>
/// <param name="Title">In a few words.</param>
/// <param name="Message">In sentences that name the setting to change; fit for a terminal.</param>
/// <param name="Color">How bad it is.</param>
internal readonly record struct Problem(string Title, string Message, Color Color);
