#nullable enable

using System;
using System.IO;
using System.Linq;
using System.Text;
using System.Xml;
using System.Xml.Linq;

namespace NeuronMocap.Unity.EditorTools
{
    // Edits the Info.plist of an exported Xcode project as XML. Unity's own type for it comes with the iOS module, which most computers do not have.
    internal static class InfoPlist
    {
        public const string LocalNetworkKey = "NSLocalNetworkUsageDescription";

        public static bool HasLocalNetworkText(string xml) => FindValue(Parse(xml), out _)?.Value.Trim().Length > 0;

        // Returns the document with the text under the key. An existing text stays: the user or another package wrote it.
        public static string WithLocalNetworkText(string xml, string text)
        {
            XDocument document = Parse(xml);
            XElement? value = FindValue(document, out XElement entries);
            if (value?.Value.Trim().Length > 0)
                return xml;

            var content = new XElement("string", text);
            if (value is not null)
                value.ReplaceWith(content);
            else
                entries.Add(new XText("  "), new XElement("key", LocalNetworkKey), new XText("\n    "), content, new XText("\n  "));

            return Write(document);
        }

        private static XElement? FindValue(XDocument document, out XElement entries)
        {
            entries = document.Root is { Name: { LocalName: "plist" } } root && root.Element("dict") is { } dict
                ? dict
                : throw new FormatException("The file is not a property list: it has no plist element with a dict.");
            XElement? key = entries.Elements("key").FirstOrDefault(element => string.Equals(element.Value.Trim(), LocalNetworkKey, StringComparison.Ordinal));
            return key?.ElementsAfterSelf().FirstOrDefault();
        }

        // Without a resolver, the parser does not look up the document type of the property list on the network.
        private static XDocument Parse(string xml)
        {
            var settings = new XmlReaderSettings { DtdProcessing = DtdProcessing.Parse, XmlResolver = null };
            using var reader = XmlReader.Create(new StringReader(xml), settings);
            try
            {
                return XDocument.Load(reader, LoadOptions.PreserveWhitespace);
            }
            catch (XmlException exception)
            {
                throw new FormatException($"The file is not valid XML: {exception.Message}", exception);
            }
        }

        private static string Write(XDocument document)
        {
            // An empty internal subset would be written as "[]", which Apple's parser rejects.
            if (document.DocumentType is { InternalSubset: "" } type)
                type.InternalSubset = null;

            using var stream = new MemoryStream();
            var settings = new XmlWriterSettings
            {
                Encoding = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false),
                NewLineHandling = NewLineHandling.None,
            };
            using (XmlWriter writer = XmlWriter.Create(stream, settings))
                document.Save(writer);

            return Encoding.UTF8.GetString(stream.ToArray());
        }
    }
}
