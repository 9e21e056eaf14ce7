#nullable enable

namespace NeuronMocap.Unity.EditorTools
{
    // A row of a report: a label and its value.
    internal readonly struct ReportRow
    {
        public ReportRow(string name, string value, Severity severity = Severity.None)
        {
            Name = name;
            Value = value;
            Severity = severity;
        }

        public string Name { get; }

        public string Value { get; }

        public Severity Severity { get; }

        public override string ToString() => $"{Name}: {Value}";
    }
}
