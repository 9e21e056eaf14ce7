namespace NeuronMocap.Diagnostics;

/// <summary>Options of a diagnosis.</summary>
public sealed class DiagnosisOptions
{
    /// <summary>Longest time of the whole diagnosis: 1 s to 5 minutes. The default is 10 s.</summary>
    /// <remarks>
    /// At most a quarter of it is for resolving the name, and a quarter for connecting. Three tenths are for waiting for the first byte. A fifth is for
    /// measuring the rate or searching other ports. If frames arrive at once, the diagnosis takes a fifth in total.
    /// </remarks>
    public TimeSpan Timeout { get; set; } = TimeSpan.FromSeconds(10);

    /// <summary>
    /// The kind of frames that the application wants: <see cref="PacketKind.Motion"/>, the default, <see cref="PacketKind.Calculation"/> or
    /// <see cref="PacketKind.StudioCalculation"/>.
    /// </summary>
    public PacketKind Expected { get; set; } = PacketKind.Motion;

    /// <summary>
    /// Whether to search beyond the reader's port if nothing arrives there. The default is true.
    /// </summary>
    /// <remarks>
    /// The search connects to the other usual data ports of the same host, and listens on the usual UDP ports of this computer. It also sends two small
    /// requests to a silent server to identify it, each on its own connection. One is a command that only reads, the other an HTTP request.
    /// Data servers ignore both.
    /// </remarks>
    public bool SearchOtherPorts { get; set; } = true;

    // The port of Axis Studio's "Advanced BVH", which this library does not support but which shows that the server runs.
    private const int AdvancedBvhPort = 7007;

    // The usual ports of the stream: those of protocol.md section 4.3, and 7012, the default of several receivers. Tests replace them.
    internal int[] UsualTcpPorts { get; set; } = [7001, 7002, 7003, 7004, 7005, 7006, AdvancedBvhPort, 8012];

    internal int[] UsualUdpPorts { get; set; } = [7001, 7002, 7003, 7004, 7012];

    internal DiagnosisBudget Budget { get; set; } = new();

    internal DiagnosisOptions Copy() => (DiagnosisOptions)MemberwiseClone();

    internal string? FindFault()
    {
        if (Timeout < TimeSpan.FromSeconds(1) || Timeout > TimeSpan.FromMinutes(5))
            return $"Timeout is {Timeout}; it must be 1 s to 5 minutes.";
        if (Expected is not (PacketKind.Motion or PacketKind.Calculation or PacketKind.StudioCalculation))
            return $"Expected is {Expected}; it must be Motion, Calculation or StudioCalculation.";

        return null;
    }
}
