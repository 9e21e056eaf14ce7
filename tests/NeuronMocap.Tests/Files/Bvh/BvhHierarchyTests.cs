using System.Numerics;
using System.Text;
using NeuronMocap.Bvh;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

public class BvhHierarchyTests
{
    [Fact]
    public void Joints_offsets_channels_and_end_sites_are_read()
    {
        BvhDocument document = Parse(TwoRows);

        Assert.Equal("Hips Spine", NamesOf(document));
        (BvhJoint hips, BvhJoint spine) = (document.Joints[0], document.Joints[1]);
        Assert.Null(hips.Parent);
        Assert.Same(hips, spine.Parent);
        Assert.Equal([0, 1], document.Joints.Select(joint => joint.Index));
        Assert.Equal(new Vector3(0, 93.02f, 0), hips.Offset);
        Assert.True(float.IsNegative(hips.Offset.Z));
        Assert.Equal(new Vector3(0.5f, 14.307f, 0.1f), spine.Offset);
        Assert.Null(hips.EndSite);
        Assert.Equal(new Vector3(0, 15.95f, -2), spine.EndSite);
        Assert.Equal(
            [BvhChannel.Xposition, BvhChannel.Yposition, BvhChannel.Zposition, BvhChannel.Yrotation, BvhChannel.Xrotation, BvhChannel.Zrotation],
            hips.Channels);
        Assert.Equal([BvhChannel.Yrotation, BvhChannel.Xrotation, BvhChannel.Zrotation], spine.Channels);
        Assert.Equal([0, 6], document.Joints.Select(joint => joint.FirstChannel));
        Assert.Equal(9, document.ChannelCount);
        Assert.Empty(document.Repairs);
    }

    [Fact]
    public void A_hierarchy_alone_is_a_document()
    {
        BvhDocument document = Parse(Hierarchy);

        Assert.Equal(2, document.Joints.Count);
        Assert.Equal(0, document.FrameCount);
        Assert.Equal(0, document.DeclaredFrameTime);
        Assert.Empty(document.Repairs);
    }

    [Theory]
    [InlineData("\r\n")]
    [InlineData("\r")]
    [InlineData("\n")]
    public void Line_ends_do_not_change_the_document(string lineEnd)
    {
        string text = TwoRows + "1 2 x\n";
        AssertSame(Parse(text), Parse(text.Replace("\n", lineEnd, StringComparison.Ordinal)));
    }

    [Fact]
    public void White_space_is_ignored()
    {
        string text = TwoRows.Replace(" ", " \t  ", StringComparison.Ordinal).Replace("\n", "\t\n\n \n", StringComparison.Ordinal);
        AssertSame(Parse(TwoRows), Parse(text));
    }

    [Fact]
    public void A_file_of_few_lines_is_read()
    {
        string text = Hierarchy.Replace("\n", " ", StringComparison.Ordinal);
        AssertSame(Parse(TwoRows), Parse(text + "MOTION Frames: 2 Frame Time: 0.008 1 2 3 4 5 6 7 8 9\n-1 -2 -3 -4 -5 -6 -7 -8 -9"));
    }

    [Fact]
    public void A_byte_order_mark_is_skipped() => AssertSame(Parse(TwoRows), Parse("\uFEFF" + TwoRows));

    [Fact]
    public void Keywords_are_read_in_any_case()
    {
        foreach (string text in (string[])[TwoRows.ToUpperInvariant(), TwoRows.ToLowerInvariant()])
        {
            string named = text
                .Replace("Hips", "Hips", StringComparison.OrdinalIgnoreCase)
                .Replace("Spine", "Spine", StringComparison.OrdinalIgnoreCase);
            AssertSame(Parse(TwoRows), Parse(named));
        }
    }

    [Theory]
    [InlineData("腰")]
    [InlineData("Hüfte")]
    [InlineData("Left Upper  Leg")]
    [InlineData("mixamorig:Hips")]
    public void Names_keep_every_letter(string name) =>
        Assert.Equal(name, Parse(TwoRows.Replace("Hips", name + " ", StringComparison.Ordinal)).Joints[0].Name);

    [Fact]
    public void Names_that_are_not_UTF8_are_read()
    {
        byte[] text = Encoding.Latin1.GetBytes(TwoRows.Replace("Hips", "H\u00FCfte", StringComparison.Ordinal));
        Assert.Equal("H\uFFFDfte", BvhDocument.Parse(text).Joints[0].Name);
    }

    [Fact]
    public void A_name_may_stand_on_the_next_line() =>
        AssertSame(Parse(TwoRows), Parse(TwoRows.Replace("Spine\n", "\n  Spine\n", StringComparison.Ordinal)));

    [Fact]
    public void A_statement_on_the_next_line_is_not_a_name()
    {
        BvhDocument document = Parse(TwoRows.Replace("JOINT Spine\n    {", "JOINT", StringComparison.Ordinal));

        Assert.Equal("Hips ", NamesOf(document));
        Assert.Equal(new Vector3(0.5f, 14.307f, 0.1f), document.Joints[1].Offset);
        Assert.Equal([6, 6], document.Repairs.Select(repair => repair.Line));
    }

    [Fact]
    public void Several_roots_have_no_parent()
    {
        BvhDocument document = Parse(Hierarchy + Hierarchy.Replace("HIERARCHY\n", "", StringComparison.Ordinal));

        Assert.Equal([true, false, true, false], document.Joints.Select(joint => joint.Parent is null));
        Assert.Equal(18, document.ChannelCount);
        Assert.Empty(document.Repairs);
    }

    [Theory]
    [InlineData("        OFFSET 0.5 14.307 1e-1\n", "", 13, "no OFFSET")]
    [InlineData("14.307 1e-1", "14.307", 8, "lacks a number")]
    [InlineData("14.307 1e-1", "14.307 nan", 8, "'nan'")]
    [InlineData("CHANNELS 3", "CHANNELS 6", 9, "declares '6' but names 3")]
    [InlineData("CHANNELS 6", "CHANNELS 5", 5, "declares '5' but names 6")]
    [InlineData("CHANNELS 3", "CHANNELS", 9, "declares no number but names 3")]
    [InlineData("Zrotation\n        End", "Zrotatoin\n        End", 9, "'Zrotatoin'")]
    [InlineData("ROOT Hips", "JOINT Hips", 2, "read as a ROOT")]
    [InlineData("JOINT Spine", "ROOT Spine", 6, "read as a JOINT")]
    [InlineData("JOINT Spine", "JOINT", 6, "no name")]
    [InlineData("Spine\n    {", "Spine\n", 6, "no {")]
    [InlineData("        }\n", "", 15, "ends inside joint 'Hips'")]
    [InlineData("        End", "        # by hand\n        End", 10, "'#'")]
    [InlineData("HIERARCHY", "some words\nHIERARCHY", 1, "begins with 'some'")]
    public void Unambiguous_defects_are_repaired_and_reported(string original, string faulty, int line, string told)
    {
        Assert.Contains(original, TwoRows, StringComparison.Ordinal);
        string text = TwoRows.Replace(original, faulty, StringComparison.Ordinal);
        BvhDocument document = Parse(text);

        Assert.Equal(2, document.Joints.Count);
        Assert.Equal(9, document.ChannelCount);
        AssertBits(Values(Parse(TwoRows)), Values(document));
        BvhRepair repair = OnlyRepair(document);
        Assert.Contains(told, repair.Description, StringComparison.Ordinal);
        Assert.Equal(line, repair.Line);
    }

    [Fact]
    public void A_closing_brace_too_many_is_ignored()
    {
        BvhDocument document = Parse(Hierarchy + "}\n");
        Assert.Equal(new BvhRepair(16, 1, "There is a } that closes nothing; it is ignored."), OnlyRepair(document));
    }

    [Fact]
    public void An_unclosed_end_site_ends_at_the_next_joint()
    {
        string text = Hierarchy.Replace("        }\n    }", "        JOINT Head\n { OFFSET 1 2 3 CHANNELS 0 }\n    }", StringComparison.Ordinal);
        BvhDocument document = Parse(text);

        Assert.Equal("Hips Spine Head", NamesOf(document));
        Assert.Equal(new Vector3(0, 15.95f, -2), document.Joints[1].EndSite);
        Assert.Same(document.Joints[1], document.Joints[2].Parent);
        Assert.Equal(13, OnlyRepair(document).Line);
    }

    [Theory]
    [InlineData("", 1, 1, "empty")]
    [InlineData(" \r\n\t ", 2, 3, "empty")]
    [InlineData("ROOT Hips {}", 1, 1, "no HIERARCHY; it begins with 'ROOT'")]
    [InlineData("\n  MOTION\nFrames: -6.27744e+66\n\n\nMOTION\nMOTION\n", 2, 3, "no HIERARCHY; it begins with 'MOTION'")]
    [InlineData("HIERARCHY\nMOTION\nFrames: 0\n", 2, 1, "no joints")]
    [InlineData("HIERARCHY\n", 2, 1, "no joints")]
    [InlineData("HIERARCHY\nROOT a { CHANNELS 1 Xposition CHANNELS 1 Yposition", 2, 42, "second CHANNELS of joint 'a'")]
    [InlineData("HIERARCHY\nROOT a { End Site { CHANNELS 1 Yposition", 2, 32, "End Site of joint 'a'")]
    public void Unreadable_text_is_refused_with_its_place(string text, int line, int column, string told)
    {
        BvhFormatException refusal = Assert.Throws<BvhFormatException>(() => Parse(text));

        Assert.Contains(told, refusal.Message, StringComparison.Ordinal);
        Assert.Equal((line, column), (refusal.Line, refusal.Column));
        Assert.StartsWith($"line {line}, column {column}: ", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void The_limit_of_joints_is_inclusive()
    {
        string atLimit = "HIERARCHY\n" + string.Concat(Enumerable.Repeat("ROOT a { OFFSET 0 0 0 }\n", BvhDocument.MaxJoints));

        Assert.Equal(BvhDocument.MaxJoints, Parse(atLimit).Joints.Count);
        BvhFormatException refusal = Assert.Throws<BvhFormatException>(() => Parse(atLimit + "ROOT a { OFFSET 0 0 0 }\n"));
        Assert.Equal(BvhDocument.MaxJoints + 2, refusal.Line);
    }

    [Fact]
    public void The_limit_of_depth_is_inclusive()
    {
        Assert.Equal(BvhDocument.MaxDepth, Parse(Nested(BvhDocument.MaxDepth)).Joints.Count);
        Assert.Throws<BvhFormatException>(() => Parse(Nested(BvhDocument.MaxDepth + 1)));
    }

    [Fact]
    public void The_limit_of_channels_is_inclusive()
    {
        string channels = string.Concat(Enumerable.Repeat(" Xposition", BvhDocument.MaxChannels));
        Assert.Equal(BvhDocument.MaxChannels, Parse($"HIERARCHY\nROOT a {{ OFFSET 0 0 0 CHANNELS 1{channels}\n}}").ChannelCount);
        BvhFormatException refusal = Assert.Throws<BvhFormatException>(
            () => Parse($"HIERARCHY\nROOT a {{ OFFSET 0 0 0 CHANNELS 1{channels}\nXposition }}"));
        Assert.Equal((3, 1), (refusal.Line, refusal.Column));
    }

    [Theory]
    [InlineData(BvhText.LongestWord, true)]
    [InlineData(BvhText.LongestWord + 1, false)]
    public void The_limit_of_name_length_is_inclusive(int length, bool isRead)
    {
        string text = TwoRows.Replace("Hips", new string('h', length), StringComparison.Ordinal);
        string reading = BvhReadings.AssertAlike(Encoding.UTF8.GetBytes(text), seed: 1);
        Assert.Equal(!isRead, reading.StartsWith("refused: line 2, column 6: A name is longer", StringComparison.Ordinal));
    }

    private static string Nested(int depth) => "HIERARCHY\nROOT a { OFFSET 0 0 0\n"
        + string.Concat(Enumerable.Repeat("JOINT a { OFFSET 0 0 0\n", depth - 1))
        + new string('}', depth);
}
