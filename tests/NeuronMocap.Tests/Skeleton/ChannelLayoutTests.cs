using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Skeleton;

public sealed class ChannelLayoutTests
{
    [Theory]
    [InlineData(false, false, 180)]
    [InlineData(false, true, 186)]
    [InlineData(true, false, 354)]
    [InlineData(true, true, 360)]
    public void Two_settings_give_the_number_of_values(bool displacement, bool reference, int expected)
    {
        var layout = new ChannelLayout(displacement, reference);
        Assert.Equal(expected, layout.ValueCount);
        Assert.True(ChannelLayout.TryFromValueCount(expected, out ChannelLayout found));
        Assert.Equal(layout, found);
    }

    [Fact]
    public void Exactly_four_value_counts_are_a_skeleton()
    {
        int[] found = [.. Enumerable.Range(-10, 2000).Where(count => ChannelLayout.TryFromValueCount(count, out _))];
        Assert.Equal([180, 186, 354, 360], found);
        Assert.False(ChannelLayout.TryFromValueCount(int.MaxValue, out _));
        Assert.False(ChannelLayout.TryFromValueCount(int.MinValue, out _));
    }

    // Position and rotation of Hips 0, RightUpLeg 1, Neck 10, RightHand 16 and LeftHandPinky3 58, from the manual's formulas.
    [Theory]
    [InlineData(180, 0, 0, 3)]
    [InlineData(180, 1, -1, 6)]
    [InlineData(180, 10, -1, 33)]
    [InlineData(180, 16, -1, 51)]
    [InlineData(180, 58, -1, 177)]
    [InlineData(186, 0, 6, 9)]
    [InlineData(186, 1, -1, 12)]
    [InlineData(186, 10, -1, 39)]
    [InlineData(186, 16, -1, 57)]
    [InlineData(186, 58, -1, 183)]
    [InlineData(354, 0, 0, 3)]
    [InlineData(354, 1, 6, 9)]
    [InlineData(354, 10, 60, 63)]
    [InlineData(354, 16, 96, 99)]
    [InlineData(354, 58, 348, 351)]
    [InlineData(360, 0, 6, 9)]
    [InlineData(360, 1, 12, 15)]
    [InlineData(360, 10, 66, 69)]
    [InlineData(360, 16, 102, 105)]
    [InlineData(360, 58, 354, 357)]
    public void A_bones_values_have_the_manuals_indices(int values, int bone, int position, int rotation)
    {
        Assert.True(ChannelLayout.TryFromValueCount(values, out ChannelLayout layout));
        Assert.Equal(position, layout.GetPositionIndex((Bone)bone));
        Assert.Equal(rotation, layout.GetRotationIndex((Bone)bone));
    }

    [Theory]
    [InlineData(180)]
    [InlineData(186)]
    [InlineData(354)]
    [InlineData(360)]
    public void Every_value_belongs_to_exactly_one_channel(int values)
    {
        Assert.True(ChannelLayout.TryFromValueCount(values, out ChannelLayout layout));
        int[] owners = new int[values];
        for (int i = 0; i < (layout.HasReference ? 6 : 0); i++)
            owners[i]++;

        foreach (Bone bone in BoneHierarchy.Bones)
        {
            for (int i = 0; i < 3; i++)
            {
                owners[layout.GetRotationIndex(bone) + i]++;
                if (layout.GetPositionIndex(bone) >= 0)
                    owners[layout.GetPositionIndex(bone) + i]++;
            }
        }

        Assert.All(owners, count => Assert.Equal(1, count));
    }
}
