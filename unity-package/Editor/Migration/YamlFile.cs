#nullable enable

using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // The objects in the text of a scene or a prefab, as far as the search for vendor components needs them.
    internal sealed class YamlFile
    {
        private const int MonoBehaviourClass = 114;
        private const int PrefabInstanceClass = 1001;
        private const string Separator = "--- !u!";

        private readonly string _text;
        private List<YamlDocument>? _documents;

        private YamlFile(string text) => _text = text;

        // Unity also writes binary files, depending on the project's settings.
        public bool IsText => _text.StartsWith("%YAML", StringComparison.Ordinal);

        public IEnumerable<YamlDocument> Scripts => Documents.Where(document => document.ClassId == MonoBehaviourClass && !document.IsStripped);

        public IEnumerable<PrefabChange> Changes => Documents.Where(document => document.ClassId == PrefabInstanceClass).SelectMany(document => document.Changes);

        private List<YamlDocument> Documents => _documents ??= Parse();

        // path: an asset path. Null if there is no such file, as for a scene that was never saved.
        public static YamlFile? Read(string path)
        {
            string full = Path.Combine(Path.GetDirectoryName(Application.dataPath) ?? string.Empty, path);
            return path.Length > 0 && File.Exists(full) ? new YamlFile(File.ReadAllText(full)) : null;
        }

        public bool Mentions(string guid) => _text.Contains(guid);

        public YamlDocument? Find(long id) => Documents.Find(document => document.Id == id);

        private List<YamlDocument> Parse()
        {
            var documents = new List<YamlDocument>();
            using var reader = new StringReader(IsText ? _text : string.Empty);
            while (reader.ReadLine() is { } line)
            {
                if (line.StartsWith(Separator, StringComparison.Ordinal))
                    documents.Add(ParseHeader(line));
                else if (documents.Count > 0)
                    documents[documents.Count - 1].Add(line);
            }

            return documents;
        }

        // Class, number and whether it is stripped: "--- !u!1 &123 stripped".
        private static YamlDocument ParseHeader(string line)
        {
            string[] words = line.Substring(Separator.Length).Split(' ');
            _ = int.TryParse(words[0], NumberStyles.Integer, CultureInfo.InvariantCulture, out int classId);
            long id = 0;
            if (words.Length > 1)
                _ = long.TryParse(words[1].TrimStart('&'), NumberStyles.Integer, CultureInfo.InvariantCulture, out id);

            return new YamlDocument(classId, id, words.Length > 2);
        }
    }
}
