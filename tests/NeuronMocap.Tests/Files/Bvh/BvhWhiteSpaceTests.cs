using System.Globalization;
using System.Text;
using NeuronMocap.Bvh;

namespace NeuronMocap.Tests.Bvh;

/// <summary>Every kind of white space between every two tokens of a file.</summary>
public class BvhWhiteSpaceTests
{
    // A space marks required white space, a middle dot marks required white space within the line, and ~ marks optional white space.
    private const string File =
        "~HIERARCHY ROOT·Hips~{~OFFSET 1 2.5 -3 CHANNELS 3 Xposition Yrotation Zrotation JOINT·Spine~{~OFFSET 4 5 6 CHANNELS 1 Xrotation "
        + "End·Site~{~OFFSET 7 8 9~}~}~}~MOTION Frames:·2 Frame·Time:·0.01 1·2·3·4\n5·6·7·8\n";

    private static readonly string[] SameLine = [" ", "\t", "  ", " \t", "\t ", "\v", "\f", new(' ', 40)];

    private static readonly string[] LineEnds =
        ["\n", "\r\n", "\r", "\n\n", "\r\n\r\n", "\r\r", "\n\r", " \n", "\n ", "\r\n\t", "\r  ", "\t\r\n \t\n", "\n" + new string(' ', 16), "\n" + new string('\t', 17)];

    private static readonly int[] Gaps = [.. File.Select(static (letter, index) => (letter, index)).Where(static pair => pair.letter is ' ' or '·' or '~').Select(static pair => pair.index)];

    public static TheoryData<int> GapPlaces => [.. Gaps];

    [Theory]
    [MemberData(nameof(GapPlaces))]
    public void Every_white_space_between_two_tokens_gives_the_same_take(int gap)
    {
        string expected = Describe(BvhDocument.Parse(Encoding.ASCII.GetBytes(Write(gap, " "))));
        string[] shapes = File[gap] switch
        {
            '~' => ["", .. SameLine, .. LineEnds],
            ' ' => [.. SameLine, .. LineEnds],
            _ => SameLine,
        };
        int place = Write(gap, "").Length - File[(gap + 1)..].Count(static letter => letter != '~');
        foreach (string shape in shapes)
            AssertReads(Write(gap, shape), expected, Math.Max(0, place - 2), place + shape.Length + 2);
    }

    [Theory]
    [InlineData("")]
    [InlineData(" ")]
    [InlineData("\t")]
    [InlineData("\n")]
    [InlineData("\r\n")]
    [InlineData("\r")]
    [InlineData("\r\n \t")]
    public void The_same_white_space_between_all_tokens_gives_the_same_take(string shape)
    {
        string expected = Describe(BvhDocument.Parse(Encoding.ASCII.GetBytes(Write(-1, ""))));
        AssertReads(Write(-1, shape), expected);
    }

    // If a line break is not allowed, it is repaired or rejected with its place. Nothing else changes.
    [Theory]
    [MemberData(nameof(GapPlaces))]
    public void Misplaced_white_space_is_repaired_or_refused(int gap)
    {
        foreach (string shape in (string[])["", .. LineEnds])
            BvhReadings.AssertAlike(Encoding.ASCII.GetBytes(Write(gap, shape)), seed: gap);
    }

    // A name may be on the line after its keyword.
    [Theory]
    [InlineData("\n")]
    [InlineData("\r\n")]
    [InlineData("\r")]
    public void A_name_may_stand_on_the_next_line(string lineEnd)
    {
        string expected = Describe(BvhDocument.Parse(Encoding.ASCII.GetBytes(Write(-1, ""))));
        AssertReads(Write(File.IndexOf('·', StringComparison.Ordinal), lineEnd), expected);
    }

    [Theory]
    [InlineData("{OFFSET", "    ")]
    [InlineData("{ OFFSET", "    ")]
    [InlineData("{\nOFFSET", "")]
    [InlineData("{\n\t\tOFFSET", "\t\t")]
    [InlineData("{\r\n  OFFSET", "  ")]
    [InlineData("{\r OFFSET", " ")]
    [InlineData("{ CHANNELS 0 OFFSET", "    ")]
    [InlineData("{\n \n  CHANNELS 0\n   OFFSET", "   ")]
    public void The_indentation_precedes_the_first_offset(string text, string indentation)
    {
        byte[] file = Encoding.ASCII.GetBytes($"HIERARCHY\nROOT i\n{text} 0 0 0\n}}");
        BvhDocument document = BvhDocument.Parse(file);

        Assert.Equal(indentation, document.TextFormat.Indentation);
        BvhReadings.AssertAlike(file, seed: 1);
    }

    [Fact]
    public void An_offset_directly_after_its_brace_is_read()
    {
        byte[] file = "HIERARCHY\nROOT i\n{OFFSET"u8.ToArray();
        Assert.Equal(24, file.Length);
        Assert.Equal("i", Assert.Single(BvhDocument.Parse(file).Joints).Name);
        BvhReadings.AssertAlike(file, seed: 1);
    }

    // from, to: the splits to try. White space that differs in one place needs only those around it.
    private static void AssertReads(string text, string expected, int from = 0, int to = int.MaxValue)
    {
        byte[] file = Encoding.ASCII.GetBytes(text);
        BvhReadings.AssertAlike(file, seed: text.Length);
        BvhDocument document = BvhDocument.Parse(file);
        Assert.Empty(document.Repairs);
        Assert.Equal(expected, Describe(document));

        using var written = new MemoryStream();
        document.Save(written);
        Assert.Equal(expected, Describe(BvhDocument.Parse(written.ToArray())));
        for (int split = from; split <= Math.Min(file.Length, to); split++)
            AssertSplit(file, split, expected);
    }

    private static void AssertSplit(byte[] file, int split, string expected)
    {
        int pieces = 0;
        Assert.Equal(expected, Describe(BvhDocument.Load(new PieceStream(file, () => pieces++ == 0 ? split : file.Length))));
    }

    private static string Write(int gap, string shape)
    {
        var text = new StringBuilder();
        for (int i = 0; i < File.Length; i++)
        {
            bool isGap = i == gap;
            text.Append(File[i] switch
            {
                '~' => isGap || gap < 0 ? shape : "",
                ' ' when isGap => shape,
                ' ' => gap < 0 && shape.Length > 0 ? shape : " ",
                '·' => isGap ? shape : " ",
                _ => File[i].ToString(),
            });
        }

        return text.ToString();
    }

    private static string Describe(BvhDocument document)
    {
        var text = new StringBuilder();
        foreach (BvhJoint joint in document.Joints)
            text.Append(CultureInfo.InvariantCulture, $"{joint.Name} < {joint.Parent?.Name} {joint.Offset} {joint.EndSite} {string.Join(' ', joint.Channels)}\n");

        text.Append(CultureInfo.InvariantCulture, $"{document.FrameRate}: ");
        for (int frame = 0; frame < document.FrameCount; frame++)
            text.AppendJoin(' ', document.GetValues(frame).ToArray()).Append('\n');

        return text.ToString();
    }
}
