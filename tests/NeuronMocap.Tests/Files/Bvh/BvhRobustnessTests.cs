using System.Text;
using NeuronMocap.Bvh;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

public class BvhRobustnessTests
{
    private const string Bits = "{}\r\n\t .:-+e019AFHJMOREndSitepos\0\xFF";

    [Fact]
    public void Every_truncation_is_read_or_refused()
    {
        byte[] text = Encoding.UTF8.GetBytes(TwoRows + "MOTION\r\nFrames: 1e3\r\nFrame Time: 0.01\r\nnan 2");
        int refused = 0;
        for (int length = 0; length <= text.Length; length++)
            refused += IsRead(text.AsSpan(0, length), $"the first {length} bytes") ? 0 : 1;

        Assert.InRange(refused, "HIERARCHY\nROOT".Length, Hierarchy.Length);
    }

    [Fact]
    public void Random_changes_are_read_or_refused()
    {
        byte[] original = Encoding.UTF8.GetBytes(TwoRows);
        byte[] bits = Encoding.Latin1.GetBytes(Bits);
        int read = 0;
        for (int seed = 0; seed < 5_000; seed++)
        {
            var random = new Random(seed);
            byte[] text = Mutate(original, bits, random);
            read += IsRead(text, $"seed {seed}") ? 1 : 0;
        }

        Assert.InRange(read, 1_000, 5_000);
    }

    [Fact]
    public void Random_words_are_read_or_refused()
    {
        string[] words =
        [
            "HIERARCHY", "ROOT", "JOINT", "End", "Site", "OFFSET", "CHANNELS", "MOTION", "Frames:", "Frame", "Time:", "{", "}",
            "Xposition", "Zrotation", "a", "0", "1", "3", "-2.5", "1e99", "nan", "\n", "\r\n", ":",
        ];
        for (int seed = 0; seed < 5_000; seed++)
        {
            var random = new Random(seed);
            IEnumerable<string> picked = Enumerable.Range(0, random.Next(60)).Select(_ => words[random.Next(words.Length)]);
            IsRead(Encoding.UTF8.GetBytes("HIERARCHY ROOT a { " + string.Join(' ', picked)), $"seed {seed}");
        }
    }

    [Theory]
    [InlineData("2000000000")]
    [InlineData("2147483647")]
    [InlineData("4294967296")]
    [InlineData("1e300")]
    [InlineData("-6.27744e+66")]
    public void Memory_follows_the_text_not_its_headings(string frames)
    {
        byte[] text = Encoding.UTF8.GetBytes($"{Hierarchy}MOTION\nFrames: {frames}\nFrame Time: 0.008\n{Row}");
        BvhDocument.Parse(text);

        long before = GC.GetAllocatedBytesForCurrentThread();
        BvhDocument.Parse(text);
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 1, 16_384);
    }

    // Found by fuzzing: each fault allocated its description with the joint's whole name, even when no more faults were listed.
    [Theory]
    [InlineData("", "{")]
    [InlineData("ROOT short {", "OFFSET ")]
    [InlineData("ROOT {0} {", "OFFSET ")]
    public void A_file_of_defects_is_described_briefly(string start, string fault)
    {
        string name = string.Concat(Enumerable.Repeat("a_joint_with_a_long_name", 400));
        string faults = string.Concat(Enumerable.Repeat(fault, 5_000));
        byte[] text = Encoding.UTF8.GetBytes("HIERARCHY " + start.Replace("{0}", name, StringComparison.Ordinal) + faults + "\nROOT b {}");
        BvhDocument.Parse(text);

        long before = GC.GetAllocatedBytesForCurrentThread();
        BvhDocument document = BvhDocument.Parse(text);
        long allocated = GC.GetAllocatedBytesForCurrentThread() - before;

        Assert.InRange(document.RepairCount, 5_000, 20_100);
        Assert.Equal(BvhDocument.MaxListedRepairs, document.Repairs.Count);
        Assert.All(document.Repairs, repair => Assert.InRange(repair.Description.Length, 1, 200));
        Assert.InRange(allocated, 1, 200_000);
    }

    // The remains of a failed recording: once without its start and once with it.
    [Fact]
    public void A_corrupt_file_of_headings_and_blank_lines_is_refused_or_read_without_frames()
    {
        string rest = $"MOTION\r\nFrames: -6.27744e+66\r\nFrame Time: 0.008\r\n{string.Concat(Enumerable.Repeat("\r\n", 138_000))}MOTION\r\nFrames: -6.27744e+66\r\nMOTION\r\n";
        Assert.Equal(
            "refused: line 1, column 1: The file has no HIERARCHY; it begins with 'MOTION'. (1, 1)",
            BvhReadings.AssertAlike(Encoding.UTF8.GetBytes(rest), seed: 1));

        BvhDocument document = Parse(Hierarchy + rest);
        Assert.Equal(0, document.FrameCount);
        Assert.Equal(
            [(17, 9), (138_019, 1), (138_020, 9), (138_021, 1), (138_021, 1)],
            document.Repairs.Select(repair => (repair.Line, repair.Column)));
    }

    // Loading allocates only the values. It copies neither the file nor rows from one array to another.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_file_is_loaded_into_its_values_and_a_window(bool isHonest)
    {
        const int frames = 20_000;
        string path = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName() + ".bvh");
        try
        {
            File.WriteAllText(path, $"{Hierarchy}MOTION\nFrames: {(isHonest ? frames : 3)}\nFrame Time: 0.008\n{string.Concat(Enumerable.Repeat(Row, frames))}");
            BvhDocument.Load(path);

            long before = GC.GetAllocatedBytesForCurrentThread();
            BvhDocument document = BvhDocument.Load(path);
            long allocated = GC.GetAllocatedBytesForCurrentThread() - before;

            Assert.Equal(frames, document.FrameCount);
            const int values = frames * 9 * sizeof(float);
            Assert.InRange(allocated, values, isHonest ? values + 32_768 : (4 * values) + 32_768);
        }
        finally
        {
            File.Delete(path);
        }
    }

    [Fact]
    public void A_valid_file_takes_little_more_than_its_values()
    {
        const int frames = 10_000;
        string rows = string.Concat(Enumerable.Repeat(Row, frames));
        byte[] text = Encoding.UTF8.GetBytes($"{Hierarchy}MOTION\nFrames: {frames}\nFrame Time: 0.008\n{rows}");
        BvhDocument.Parse(text);

        long before = GC.GetAllocatedBytesForCurrentThread();
        BvhDocument document = BvhDocument.Parse(text);
        long allocated = GC.GetAllocatedBytesForCurrentThread() - before;

        Assert.Equal(frames, document.FrameCount);
        Assert.InRange(allocated, frames * 9 * sizeof(float), (frames * 9 * sizeof(float)) + 16_384);
    }

    private static byte[] Mutate(byte[] original, byte[] bits, Random random)
    {
        List<byte> text = [.. original];
        for (int changes = random.Next(1, 8); changes > 0; changes--)
        {
            int at = random.Next(text.Count);
            byte bit = bits[random.Next(bits.Length)];
            switch (random.Next(4))
            {
                case 0:
                    text[at] = bit;
                    break;
                case 1:
                    text.Insert(at, bit);
                    break;
                case 2:
                    text.RemoveRange(at, Math.Min(text.Count - at, random.Next(1, 30)));
                    break;
                default:
                    text.InsertRange(at, text.GetRange(random.Next(at + 1), Math.Min(random.Next(1, 40), text.Count - at)));
                    break;
            }

            if (text.Count == 0)
                text.Add(bit);
        }

        return [.. text];
    }

    // A file that is read must also keep the documented rules.
    private static bool IsRead(ReadOnlySpan<byte> text, string which)
    {
        try
        {
            BvhDocument document = BvhDocument.Parse(text);
            Assert.NotEmpty(document.Joints);
            Assert.Equal(document.ChannelCount, document.Joints.Sum(joint => joint.Channels.Count));
            Assert.All(document.Joints, (joint, index) => Assert.True(joint.Index == index && (joint.Parent?.Index ?? -1) < index));
            Assert.All(Enumerable.Range(0, document.FrameCount), frame => Assert.Equal(document.ChannelCount, document.GetValues(frame).Length));
            Assert.True(double.IsFinite(document.FrameRate) && document.FrameRate > 0);
            Assert.All(document.Repairs, repair => Assert.True(repair.Line > 0));
            return true;
        }
        catch (BvhFormatException refusal)
        {
            Assert.True(refusal.Line > 0 && refusal.Column > 0, which);
            return false;
        }
        catch (Exception failure)
        {
            throw new InvalidOperationException($"Reading fails for {which}.", failure);
        }
    }
}
