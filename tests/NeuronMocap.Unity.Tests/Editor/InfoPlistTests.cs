using System.Xml.Linq;
using NeuronMocap.Unity.EditorTools;

namespace NeuronMocap.Unity.Tests.Editor;

public class InfoPlistTests
{
    private const string Text = "Receives motion capture data from a computer in your network.";

    private const string Written = """
        <?xml version="1.0" encoding="utf-8"?>
        <!DOCTYPE plist PUBLIC "-//Apple//DTD PLIST 1.0//EN" "http://www.apple.com/DTDs/PropertyList-1.0.dtd">
        <plist version="1.0">
          <dict>
            <key>CFBundleName</key>
            <string>Größe &amp; Ruhm</string>
            <key>UIRequiredDeviceCapabilities</key>
            <array>
              <string>arm64</string>
            </array>
            <key>NSAppTransportSecurity</key>
            <dict>
              <key>NSLocalNetworkUsageDescription</key>
              <string>inner</string>
            </dict>
            <key>UIStatusBarHidden</key>
            <true/>
          </dict>
        </plist>

        """;

    [Fact]
    public void The_text_is_appended_and_the_rest_is_unchanged()
    {
        string edited = InfoPlist.WithLocalNetworkText(Written, Text);
        Dictionary<string, string> before = Read(Written);
        Dictionary<string, string> after = Read(edited);

        Assert.Equal(Text, XElement.Parse(after[InfoPlist.LocalNetworkKey]).Value);
        after.Remove(InfoPlist.LocalNetworkKey);
        Assert.Equal(before, after);
    }

    [Fact]
    public void Head_and_document_type_stay_valid_for_Apple()
    {
        string edited = InfoPlist.WithLocalNetworkText(Written, Text);

        Assert.StartsWith("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<!DOCTYPE plist PUBLIC \"-//Apple//DTD PLIST 1.0//EN\" "
            + "\"http://www.apple.com/DTDs/PropertyList-1.0.dtd\">\n<plist version=\"1.0\">", edited, StringComparison.Ordinal);
        Assert.Contains("""
                <true/>
                <key>NSLocalNetworkUsageDescription</key>
                <string>Receives motion capture data from a computer in your network.</string>
              </dict>
            </plist>
            """, Lines(edited), StringComparison.Ordinal);
    }

    [Fact]
    public void Adding_twice_changes_nothing()
    {
        string once = InfoPlist.WithLocalNetworkText(Written, Text);

        Assert.True(InfoPlist.HasLocalNetworkText(once));
        Assert.Equal(once, InfoPlist.WithLocalNetworkText(once, "Another text."));
    }

    [Fact]
    public void A_key_of_an_inner_dictionary_is_ignored()
    {
        Assert.False(InfoPlist.HasLocalNetworkText(Written));
    }

    [Theory]
    [InlineData("<string></string>")]
    [InlineData("<string/>")]
    [InlineData("<string>  </string>")]
    public void An_empty_text_is_replaced(string empty)
    {
        string plist = $"<plist version=\"1.0\"><dict><key>NSLocalNetworkUsageDescription</key>{empty}<key>A</key><true/></dict></plist>";
        string edited = InfoPlist.WithLocalNetworkText(plist, Text);

        Assert.False(InfoPlist.HasLocalNetworkText(plist));
        Assert.True(InfoPlist.HasLocalNetworkText(edited));
        Assert.Equal(["NSLocalNetworkUsageDescription", "A"], Read(edited).Keys);
    }

    [Fact]
    public void The_text_is_escaped()
    {
        string edited = InfoPlist.WithLocalNetworkText(Written, "<Körper> & \"Suit\"");

        Assert.Equal("<Körper> & \"Suit\"", XElement.Parse(Read(edited)[InfoPlist.LocalNetworkKey]).Value);
    }

    [Theory]
    [InlineData("")]
    [InlineData("bplist00\u0001")]
    [InlineData("<plist version=\"1.0\"><array/></plist>")]
    [InlineData("<plist version=\"1.0\"><dict>")]
    public void An_invalid_property_list_is_reported(string text)
    {
        Assert.Throws<FormatException>(() => InfoPlist.WithLocalNetworkText(text, Text));
        Assert.Throws<FormatException>(() => InfoPlist.HasLocalNetworkText(text));
    }

    // The entries of the outer dictionary, in order.
    private static Dictionary<string, string> Read(string plist) => XDocument.Parse(plist).Root!.Element("dict")!.Elements("key")
        .ToDictionary(static key => key.Value, static key => key.ElementsAfterSelf().First().ToString());

    // Writers differ in whether a space precedes the end of an empty element.
    private static string Lines(string text) => text.Replace(" />", "/>", StringComparison.Ordinal).ReplaceLineEndings("\n");
}
