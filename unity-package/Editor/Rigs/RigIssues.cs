#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using NeuronMocap.Retargeting;

namespace NeuronMocap.Unity.EditorTools
{
    // Converts the results of the library's check to rows for the inspector.
    internal static class RigIssues
    {
        public const string FixLabel = "Put Into T-Pose";

        // One click corrects the whole rest pose. The button is below the last issue that it fixes.
        public static IEnumerable<RigProblem> ToProblems(IReadOnlyList<RigIssue> issues, Action? fix, string label = FixLabel)
        {
            int last = fix is null ? -1 : issues.ToList().FindLastIndex(issue => issue.CanFix);
            return issues.Select((issue, index) => new RigProblem(
                SeverityOf(issue.Severity), issue.Message, index == last ? label : null, index == last ? fix : null));
        }

        private static Severity SeverityOf(RigSeverity severity) => severity switch
        {
            RigSeverity.Error => Severity.Error,
            RigSeverity.Warning => Severity.Warning,
            _ => Severity.None,
        };
    }
}
