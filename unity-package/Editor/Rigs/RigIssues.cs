#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using NeuronMocap.Retargeting;

namespace NeuronMocap.Unity.EditorTools
{
    // What the library's check found, as lines for the inspector.
    internal static class RigFindings
    {
        public const string FixLabel = "Put Into T-Pose";

        // One click sets all of the rest pose right: the button stands below the last finding that it helps.
        public static IEnumerable<RigProblem> ToProblems(IReadOnlyList<RigFinding> findings, Action? fix)
        {
            int last = fix is null ? -1 : findings.ToList().FindLastIndex(finding => finding.CanFix);
            return findings.Select((finding, index) => new RigProblem(
                SeverityOf(finding.Severity), finding.Message, index == last ? FixLabel : null, index == last ? fix : null));
        }

        private static Severity SeverityOf(RigSeverity severity) => severity switch
        {
            RigSeverity.Error => Severity.Error,
            RigSeverity.Warning => Severity.Warning,
            _ => Severity.None,
        };
    }
}
