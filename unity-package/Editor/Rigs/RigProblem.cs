#nullable enable

using System;

namespace NeuronMocap.Unity.EditorTools
{
    // A problem that keeps a figure from moving correctly, and the fix that one click applies.
    internal sealed class RigProblem
    {
        public RigProblem(Severity severity, string text, string? fixLabel = null, Action? fix = null)
        {
            Severity = severity;
            Text = text;
            FixLabel = fixLabel;
            Fix = fix;
        }

        public Severity Severity { get; }

        public string Text { get; }

        // The label of the button. Null if only the user can fix the problem.
        public string? FixLabel { get; }

        public Action? Fix { get; }

        public override string ToString() => $"{Severity}: {Text}";
    }
}
