using NeuronMocap.Diagnostics;

namespace NeuronMocap.Tool.Diagnose;

/// <summary>The verdicts in a few words, for the line above the paragraph.</summary>
internal static class DiagnosisTitles
{
    public static string Of(DiagnosisVerdict verdict) => verdict switch
    {
        DiagnosisVerdict.Receiving => "FRAMES ARRIVE",
        DiagnosisVerdict.OldHeader => "FRAMES ARRIVE, WITH THE OLD HEADER",
        DiagnosisVerdict.TextFormat => "FRAMES ARRIVE, AS TEXT",
        DiagnosisVerdict.UnusualValueCount => "FRAMES ARRIVE, OF ANOTHER SKELETON",
        DiagnosisVerdict.ForeignBytes => "FRAMES ARRIVE, AND OTHER BYTES BETWEEN THEM",
        DiagnosisVerdict.SeveralSenders => "FRAMES ARRIVE, FROM SEVERAL PROGRAMS",
        DiagnosisVerdict.LowRate => "FRAMES ARRIVE, BUT FEW",
        DiagnosisVerdict.LosingFrames => "FRAMES ARRIVE, BUT NOT ALL",
        DiagnosisVerdict.CalculationUnavailable => "FRAMES ARRIVE, BUT NO CALCULATION DATA",
        DiagnosisVerdict.Motionless => "FRAMES ARRIVE, BUT NOTHING MOVES",
        DiagnosisVerdict.HostNotFound => "NO SUCH COMPUTER",
        DiagnosisVerdict.Unreachable => "NO WAY TO THE COMPUTER",
        DiagnosisVerdict.NoAnswer => "NO ANSWER",
        DiagnosisVerdict.Refused => "NOTHING LISTENS ON THIS PORT",
        DiagnosisVerdict.PortInUse => "THE PORT IS IN USE",
        DiagnosisVerdict.LocalAddressUnavailable => "NOT AN ADDRESS OF THIS COMPUTER",
        DiagnosisVerdict.AccessDenied => "NOT ALLOWED",
        DiagnosisVerdict.ClosedImmediately => "THE SERVER CLOSES THE CONNECTION",
        DiagnosisVerdict.Silent => "NOTHING ARRIVES",
        DiagnosisVerdict.OtherPort => "THE STREAM IS ON ANOTHER PORT",
        DiagnosisVerdict.SentOverUdp => "THE STREAM COMES OVER UDP",
        DiagnosisVerdict.OfferedOverTcp => "THE STREAM IS ON TCP",
        DiagnosisVerdict.NoValues => "EMPTY FRAMES",
        DiagnosisVerdict.CalculationOnly => "CALCULATION DATA ONLY",
        DiagnosisVerdict.MotionOnly => "MOTION DATA ONLY",
        DiagnosisVerdict.StudioCalculationOnly => "AXIS STUDIO'S CALCULATION DATA ONLY",
        DiagnosisVerdict.MalformedText => "TEXT THAT IS NO FRAMES",
        DiagnosisVerdict.UnknownVersion => "A FORMAT VERSION THAT IS NOT KNOWN",
        DiagnosisVerdict.TooManyValues => "FRAMES THAT ARE TOO LARGE",
        DiagnosisVerdict.IncompletePackets => "FRAMES THAT ARE CUT OFF",
        DiagnosisVerdict.CommandPort => "THE COMMAND PORT",
        DiagnosisVerdict.OtherProgram => "ANOTHER PROGRAM",
        DiagnosisVerdict.AdvancedBvh => "ADVANCED BVH, WHICH IS NOT READ",
        DiagnosisVerdict.UnknownFormat => "DATA OF AN UNKNOWN FORMAT",
        _ => "NO CONNECTION",
    };
}
