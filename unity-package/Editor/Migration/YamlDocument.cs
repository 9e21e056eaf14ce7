#nullable enable

using System;
using System.Collections.Generic;
using System.Globalization;

namespace NeuronMocap.Unity.EditorTools
{
    // An object in a scene or prefab file: its own fields, without nested ones.
    internal sealed class YamlDocument
    {
        private const string FileId = "fileID: ";
        private const string Guid = "guid: ";

        private readonly Dictionary<string, string> _values = new Dictionary<string, string>(StringComparer.Ordinal);
        private string? _unfinished;

        public YamlDocument(int classId, long id, bool isStripped)
        {
            ClassId = classId;
            Id = id;
            IsStripped = isStripped;
        }

        public int ClassId { get; }

        public long Id { get; }

        // Only stands for an object of a prefab.
        public bool IsStripped { get; }

        // Of a prefab instance: the fields that it changes.
        public List<PrefabChange> Changes { get; } = new List<PrefabChange>();

        public string? Find(string name) => _values.TryGetValue(name, out string? value) ? Unquote(value) : null;

        // The local number of the object that a field refers to. 0 for none.
        public long FindReference(string name) => Find(name) is { } value ? ParseFileId(value) : 0;

        public string FindGuid(string name) => Find(name) is { } value ? ParseGuid(value) : string.Empty;

        public void Add(string line)
        {
            // A reference may continue in the next line.
            if (_unfinished is { } name)
            {
                _values[name] += " " + line.Trim();
                _unfinished = line.EndsWith("}", StringComparison.Ordinal) ? null : name;
                return;
            }

            string text = line.Trim();
            int colon = text.IndexOf(':');
            if (colon < 0)
                return;

            string value = text.Substring(colon + 1).Trim();
            if (text.StartsWith("- target:", StringComparison.Ordinal))
                Changes.Add(new PrefabChange(ParseGuid(value)));
            else if (Changes.Count > 0 && text.StartsWith("propertyPath:", StringComparison.Ordinal))
                Changes[Changes.Count - 1].Field = value;
            else if (Changes.Count > 0 && text.StartsWith("value:", StringComparison.Ordinal))
                Changes[Changes.Count - 1].Value = Unquote(value);

            if (line.StartsWith("  ", StringComparison.Ordinal) && line[2] != ' ' && line[2] != '-')
            {
                name = text.Substring(0, colon);
                _values[name] = value;
                _unfinished = value.StartsWith("{", StringComparison.Ordinal) && !value.EndsWith("}", StringComparison.Ordinal) ? name : null;
            }
        }

        private static long ParseFileId(string text)
        {
            int start = text.IndexOf(FileId, StringComparison.Ordinal);
            if (start < 0)
                return 0;

            string number = text.Substring(start + FileId.Length).Split(',', '}')[0];
            return long.TryParse(number, NumberStyles.Integer, CultureInfo.InvariantCulture, out long id) ? id : 0;
        }

        private static string ParseGuid(string text)
        {
            int start = text.IndexOf(Guid, StringComparison.Ordinal);
            return start < 0 ? string.Empty : text.Substring(start + Guid.Length).Split(',', '}')[0];
        }

        private static string Unquote(string text)
        {
            if (text.Length < 2 || text[0] != text[text.Length - 1])
                return text;

            string inside = text.Substring(1, text.Length - 2);
            return text[0] switch
            {
                '\'' => inside.Replace("''", "'"),
                '"' => inside.Replace("\\\"", "\"").Replace("\\\\", "\\"),
                _ => text,
            };
        }
    }
}
