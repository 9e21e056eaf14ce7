#nullable enable

using System;

namespace NeuronMocap.Unity.EditorTools
{
    // Something about a figure that keeps it from moving, or from moving right, and what one click can do about it.
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

        // What the button says; null where only the user can help.
        public string? FixLabel { get; }

        public Action? Fix { get; }

        public override string ToString() => $"{Severity}: {Text}";
    }
}
