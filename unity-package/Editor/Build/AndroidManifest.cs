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
        // The location of a project's own manifest, which Unity merges into the generated one.
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
                // Unity's own build reports what is wrong with the manifest.
                return false;
            }
        }
    }
}
