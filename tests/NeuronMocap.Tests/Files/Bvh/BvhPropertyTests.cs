using System.Numerics;
using System.Text;
using NeuronMocap.Bvh;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

public class BvhPropertyTests
{
    [Fact]
    public void Any_hierarchy_in_any_layout_round_trips()
    {
        for (int seed = 0; seed < 200; seed++)
        {
            var made = new RandomBvh(seed);
            BvhDocument read = BvhDocument.Parse(made.Bytes, new BvhReadOptions { Strict = true });

            Assert.Equal(made.Joints.Count, read.Joints.Count);
            foreach ((RandomBvh.Joint expected, BvhJoint actual) in made.Joints.Zip(read.Joints))
            {
                Assert.Equal(expected.Name, actual.Name);
                Assert.Equal(expected.Parent is null ? -1 : IndexOf(made, expected.Parent), actual.Parent?.Index ?? -1);
                AssertBits(expected.Offset, actual.Offset);
                Assert.Equal(expected.EndSite.HasValue, actual.EndSite.HasValue);
                AssertBits(expected.EndSite ?? default, actual.EndSite ?? default);
                Assert.Equal(expected.Channels, actual.Channels);
                Assert.Equal(expected.FirstChannel, actual.FirstChannel);
            }

            BvhSamples.AssertBits(made.Values, Values(read));
            BvhReadings.AssertAlike(made.Bytes, seed);
        }
    }

    [Fact]
    public void Every_way_of_reading_treats_damage_alike()
    {
        byte[] bits = Encoding.UTF8.GetBytes("{}\r\n\t .:-+e019AFHJMOREndSitepos\0ü");
        byte[][] parts =
        [
            .. ((string[])["MOTION\n", "Frames: 3\n", "Frame Time: 0.017\n", "HIERARCHY\n", " nan ", "1 2 3\n", " 1e39 ", "End Site", "OFFSET 1", "\r\n\r\n"])
                .Select(Encoding.UTF8.GetBytes),
        ];
        for (int seed = 0; seed < 400; seed++)
        {
            var random = new Random(seed);
            List<byte> text = [.. seed % 3 == 0 ? Encoding.UTF8.GetBytes(TwoRows) : new RandomBvh(seed / 8).Bytes];
            for (int changes = random.Next(1, 6); changes > 0; changes--)
            {
                int at = random.Next(text.Count);
                if (random.Next(3) == 0)
                    text.InsertRange(at, parts[random.Next(parts.Length)]);
                else if (random.Next(2) == 0)
                    text[at] = bits[random.Next(bits.Length)];
                else
                    text.RemoveRange(at, Math.Min(text.Count - at - 1, random.Next(1, 40)));
            }

            BvhReadings.AssertAlike([.. text], seed);
        }
    }

    private static int IndexOf(RandomBvh made, RandomBvh.Joint joint)
    {
        int index = 0;
        while (!ReferenceEquals(made.Joints[index], joint))
            index++;

        return index;
    }

    private static void AssertBits(Vector3 expected, Vector3 actual) =>
        BvhSamples.AssertBits([expected.X, expected.Y, expected.Z], [actual.X, actual.Y, actual.Z]);
}
