#nullable enable

using NeuronMocap.Diagnostics;

namespace NeuronMocap.Unity.EditorTools
{
    // The verdicts in a few words, as the monitor has them.
    internal static class DiagnosisTitles
    {
        public static string Of(DiagnosisVerdict verdict) => verdict switch
        {
            DiagnosisVerdict.Receiving => "Frames arrive",
            DiagnosisVerdict.OldHeader => "Frames arrive, with the old header",
            DiagnosisVerdict.TextFormat => "Frames arrive, as text",
            DiagnosisVerdict.UnusualValueCount => "Frames arrive, of another skeleton",
            DiagnosisVerdict.ForeignBytes => "Frames arrive, and other bytes between them",
            DiagnosisVerdict.SeveralSenders => "Frames arrive, from several programs",
            DiagnosisVerdict.LowRate => "Frames arrive, but few",
            DiagnosisVerdict.LosingFrames => "Frames arrive, but not all",
            DiagnosisVerdict.CalculationUnavailable => "Frames arrive, but no calculation data",
            DiagnosisVerdict.Motionless => "Frames arrive, but nothing moves",
            DiagnosisVerdict.HostNotFound => "No such computer",
            DiagnosisVerdict.Unreachable => "No way to the computer",
            DiagnosisVerdict.NoAnswer => "No answer",
            DiagnosisVerdict.Refused => "Nothing listens on this port",
            DiagnosisVerdict.PortInUse => "The port is in use",
            DiagnosisVerdict.LocalAddressUnavailable => "Not an address of this computer",
            DiagnosisVerdict.AccessDenied => "Not allowed",
            DiagnosisVerdict.ClosedImmediately => "The server closes the connection",
            DiagnosisVerdict.Silent => "Nothing arrives",
            DiagnosisVerdict.SenderNotAllowed => "The sender is not allowed",
            DiagnosisVerdict.OtherPort => "The stream is on another port",
            DiagnosisVerdict.SentOverUdp => "The stream comes over UDP",
            DiagnosisVerdict.OfferedOverTcp => "The stream is on TCP",
            DiagnosisVerdict.NoValues => "Empty frames",
            DiagnosisVerdict.CalculationOnly => "Calculation data only",
            DiagnosisVerdict.MotionOnly => "Motion data only",
            DiagnosisVerdict.StudioCalculationOnly => "Axis Studio's calculation data only",
            DiagnosisVerdict.MalformedText => "Text that is no frames",
            DiagnosisVerdict.UnknownVersion => "A format version that is not known",
            DiagnosisVerdict.TooManyValues => "Frames that are too large",
            DiagnosisVerdict.IncompletePackets => "Frames that are cut off",
            DiagnosisVerdict.CommandPort => "The command port",
            DiagnosisVerdict.OtherProgram => "Another program",
            DiagnosisVerdict.AdvancedBvh => "Advanced BVH, which is not read",
            DiagnosisVerdict.UnknownFormat => "Data of an unknown format",
            _ => "No connection",
        };
    }
}
