#nullable enable

using System.Globalization;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // The fields of a component whose script is gone, from the text of its file.
    internal sealed class MissingFields : IVendorFields
    {
        private readonly MigrationFile _file;
        private readonly YamlDocument _document;

        public MissingFields(MigrationFile file, YamlDocument document)
        {
            _file = file;
            _document = document;
        }

        public string? FindText(string name) => _document.Find(name);

        public float? FindNumber(string name) =>
            float.TryParse(_document.Find(name), NumberStyles.Float, CultureInfo.InvariantCulture, out float number) ? number : (float?)null;

        public T? FindObject<T>(string name)
            where T : Object => _file.FindObject(_document.FindReference(name)) as T;
    }
}
