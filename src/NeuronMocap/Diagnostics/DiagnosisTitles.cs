namespace NeuronMocap.Diagnostics;

// The titles of the verdicts, a few words each.
internal static class DiagnosisTitles
{
    public static string Of(DiagnosisVerdict verdict) => verdict switch
    {
        DiagnosisVerdict.Receiving => "Frames arrive",
        DiagnosisVerdict.OldHeader => "Frames arrive with the old header",
        DiagnosisVerdict.TextFormat => "Frames arrive as text",
        DiagnosisVerdict.UnusualValueCount => "Frames arrive with an unknown skeleton",
        DiagnosisVerdict.ForeignBytes => "Frames arrive with other bytes between them",
        DiagnosisVerdict.SeveralSenders => "Frames arrive from several programs",
        DiagnosisVerdict.LowRate => "Frames arrive, but too few",
        DiagnosisVerdict.LosingFrames => "Frames arrive, but some are lost",
        DiagnosisVerdict.CalculationUnavailable => "Frames arrive, but no calculation data",
        DiagnosisVerdict.Motionless => "Frames arrive, but nothing moves",
        DiagnosisVerdict.HostNotFound => "Host not found",
        DiagnosisVerdict.Unreachable => "No route to the computer",
        DiagnosisVerdict.NoAnswer => "No answer",
        DiagnosisVerdict.Refused => "Nothing listens on this port",
        DiagnosisVerdict.PortInUse => "Port in use",
        DiagnosisVerdict.LocalAddressUnavailable => "Not an address of this computer",
        DiagnosisVerdict.AccessDenied => "Access denied",
        DiagnosisVerdict.ClosedImmediately => "The server closes the connection",
        DiagnosisVerdict.Silent => "Nothing arrives",
        DiagnosisVerdict.SenderNotAllowed => "Sender not allowed",
        DiagnosisVerdict.OtherPort => "The stream is on another port",
        DiagnosisVerdict.SentOverUdp => "The stream comes over UDP",
        DiagnosisVerdict.OfferedOverTcp => "The stream is on TCP",
        DiagnosisVerdict.NoValues => "Empty frames",
        DiagnosisVerdict.CalculationOnly => "Calculation data only",
        DiagnosisVerdict.MotionOnly => "Motion data only",
        DiagnosisVerdict.StudioCalculationOnly => "Axis Studio's calculation data only",
        DiagnosisVerdict.MalformedText => "Malformed text",
        DiagnosisVerdict.UnknownVersion => "Unknown format version",
        DiagnosisVerdict.TooManyValues => "Frames are too large",
        DiagnosisVerdict.IncompletePackets => "Incomplete packets",
        DiagnosisVerdict.CommandPort => "The command port",
        DiagnosisVerdict.OtherProgram => "Another program",
        DiagnosisVerdict.AdvancedBvh => "Advanced BVH is not supported",
        DiagnosisVerdict.UnknownFormat => "Unknown data format",
        _ => "No connection",
    };
}
