namespace NeuronMocap.Diagnostics;

/// <summary>How a diagnosis looks, and for what.</summary>
public sealed class DiagnosisOptions
{
    /// <summary>
    /// Longest time of the whole diagnosis: 10 s unless set; 1 s to 5 minutes. Of it a quarter at most goes to the name, a quarter to
    /// connecting, three tenths to waiting for the first byte, and a fifth to measuring the rate or searching other ports. Where frames arrive at
    /// once it is a fifth in all.
    /// </summary>
    public TimeSpan Timeout { get; set; } = TimeSpan.FromSeconds(10);

    /// <summary>The frames that the application wants: <see cref="PacketKind.Motion"/> unless set, <see cref="PacketKind.Calculation"/> or <see cref="PacketKind.StudioCalculation"/>.</summary>
    public PacketKind Expected { get; set; } = PacketKind.Motion;

    /// <summary>
    /// Whether to search beyond the port that the reader would use, where nothing comes from it: connect to the other usual data ports of the
    /// same host, listen on the usual UDP ports of this computer, and ask a server that says nothing who it is, with two small requests on
    /// connections of their own (a command that only reads, and one of HTTP). Data servers pass over both. True unless set.
    /// </summary>
    public bool SearchOtherPorts { get; set; } = true;

    // Axis Studio's "Advanced BVH", which is not read, but shows that the server runs.
    private const int AdvancedBvhPort = 7007;

    // Where the stream is usually found: protocol.md section 4.3, and 7012, which several receivers have as their default. Tests have ports
    // of their own.
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
