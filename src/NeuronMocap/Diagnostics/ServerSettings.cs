using NeuronMocap.Protocol;

namespace NeuronMocap.Diagnostics;

// The places of the settings in the two programs, in the words of their dialogs.
internal static class ServerSettings
{
    public const string Binary =
        "In Axis Neuron open File > Settings > Broadcasting and set Format to Binary under BVH (in older versions: Output Format, Block type). "
        + "In Axis Studio open Settings > BVH Broadcasting and set Type to Binary under Frame Format.";

    public const string NewHeader =
        "In Axis Studio open Settings > BVH Broadcasting and clear \"Use old header format\" under Frame Format. Axis Neuron sent it until 2015: "
        + "use a newer version.";

    public const string Play =
        "Connect and calibrate the suit, or open a take and press play. Axis Studio has two broadcasts, each with its own switch: "
        + "\"BVH Broadcasting - Capture\" sends the suit, \"BVH Broadcasting - Edit\" sends a take that is played.";

    public const string FullRate =
        "In Axis Neuron open File > Settings > Output Format and set Frequency reducing to 1.";

    public const string Skeleton =
        "In Axis Studio open Settings > BVH Broadcasting and set Skeleton to \"Axis Studio\" or \"Axis Legacy\".";

    public const string DataPort = "Connect to the port of the BVH data, which the server's broadcasting settings show (usually 7001).";

    public static string BroadcastTcp(PacketKind wanted, int port, bool isRemote) => wanted is PacketKind.Calculation or PacketKind.StudioCalculation
        ? $"In Axis Neuron open File > Settings > Broadcasting, choose TCP, and tick Enable under Calculation, with port {port}. In Axis Studio switch on "
            + $"the broadcasting of calculation data in the settings, with TCP and port {port}"
            + (isRemote ? " and that computer's address in the network, not 127.0.0.1." : ".")
        : $"In Axis Neuron open File > Settings > Broadcasting, choose TCP, and tick Enable under BVH, with port {port}. In Axis Studio open "
            + $"Settings > BVH Broadcasting, switch it on, and set Protocol to TCP and the port of Local Address to {port}"
            + (isRemote ? "; Local Address itself must be that computer's address in the network, not 127.0.0.1." : ".");

    public static string BroadcastUdp(PacketKind wanted, string destination) => wanted is PacketKind.Calculation or PacketKind.StudioCalculation
        ? $"In Axis Neuron open File > Settings > Broadcasting, choose UDP, and tick Enable under Calculation, with {destination} as the client. In Axis "
            + $"Studio switch on the broadcasting of calculation data in the settings, with UDP and {destination} as the destination."
        : $"In Axis Neuron open File > Settings > Broadcasting, choose UDP, and tick Enable under BVH, with {destination} as the client. In Axis "
            + $"Studio open Settings > BVH Broadcasting, switch it on, set Protocol to UDP and Destination Address to {destination}.";

    public static string Enable(PacketKind kind) => kind switch
    {
        PacketKind.Motion =>
            $"In Axis Neuron open File > Settings > Broadcasting, tick Enable under BVH, and connect to the port shown there (usually "
            + $"{ProtocolConstants.DefaultPort}); Calculation has a separate port. In Axis Studio switch on Settings > BVH Broadcasting.",
        PacketKind.Calculation =>
            "In Axis Neuron open File > Settings > Broadcasting, tick Enable under Calculation, and connect to the port shown there "
            + "(usually 7003). Axis Studio's calculation data has another format: request StudioCalculation.",
        _ =>
            "In Axis Studio switch on the broadcasting of calculation data in the settings, and connect to the port shown there. Axis Neuron's "
            + "calculation data has another format: request Calculation.",
    };
}
