#nullable enable

using System;
using System.Collections.Generic;

namespace NeuronMocap.Unity.EditorTools
{
    // A line of the report: a vendor's component, and what takes its place or why nothing does.
    internal sealed class MigrationItem
    {
        public MigrationItem(string file, string place, string change, string reason = "", IReadOnlyList<string>? notes = null)
        {
            File = file;
            Place = place;
            Change = change;
            Reason = reason;
            Notes = notes ?? Array.Empty<string>();
        }

        // Path of a scene or a prefab.
        public string File { get; }

        // The object and the component.
        public string Place { get; }

        // What takes its place. Empty if nothing does.
        public string Change { get; }

        // Why nothing takes its place. Empty if something does.
        public string Reason { get; }

        public IReadOnlyList<string> Notes { get; }

        public bool IsConvertible => Reason.Length == 0;

        public override string ToString() => $"{File}: {Place}: {(IsConvertible ? Change : Reason)}";
    }
}
