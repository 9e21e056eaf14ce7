#nullable enable

using System;
using System.IO;
using System.Linq;
using System.Xml;
using System.Xml.Linq;

namespace NeuronMocap.Unity.EditorTools
{
    internal static class AndroidManifest
    {
        // Where a project keeps a manifest of its own, which Unity merges into the one that it writes.
        public const string CustomPath = "Assets/Plugins/Android/AndroidManifest.xml";

        private const string Permission = "android.permission.INTERNET";
        private static readonly XNamespace Android = "http://schemas.android.com/apk/res/android";
        private static readonly XNamespace Tools = "http://schemas.android.com/tools";

        public static bool HasInternetPermission(string xml)
        {
            try
            {
                var settings = new XmlReaderSettings { DtdProcessing = DtdProcessing.Prohibit, XmlResolver = null };
                using var reader = XmlReader.Create(new StringReader(xml), settings);
                return XDocument.Load(reader).Root?.Elements("uses-permission").Any(element =>
                    string.Equals((string?)element.Attribute(Android + "name"), Permission, StringComparison.Ordinal)
                    && !string.Equals((string?)element.Attribute(Tools + "node"), "remove", StringComparison.Ordinal)) == true;
            }
            catch (XmlException)
            {
                // Unity's own build says what is wrong with it.
                return false;
            }
        }
    }
}
