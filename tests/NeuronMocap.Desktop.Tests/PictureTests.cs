using System.Text;
using NeuronMocap.Desktop.Tests.Infrastructure;

namespace NeuronMocap.Desktop.Tests;

public sealed class PictureTests
{
    // The first byte of the pixels is a white space, too.
    [Fact]
    public void Pixels_of_a_colour_are_counted()
    {
        Picture picture = Picture.FromPpm([.. Encoding.ASCII.GetBytes("P6\n2 2\n255\n"), 10, 20, 30, 1, 2, 3, 10, 20, 30, 30, 20, 10]);
        Assert.Equal((2, 1, 0), (picture.Count(10, 20, 30), picture.Count(30, 20, 10), picture.Count(20, 30, 1)));
    }

    [Fact]
    public void A_picture_is_the_same_as_its_copy_only()
    {
        Picture picture = OfOnePixel(7);
        Assert.True(picture.IsSameAs(OfOnePixel(7)));
        Assert.False(picture.IsSameAs(OfOnePixel(8)));
    }

    [Fact]
    public void A_picture_without_its_last_byte_is_refused() =>
        Assert.ThrowsAny<Xunit.Sdk.XunitException>(() => Picture.FromPpm(Encoding.ASCII.GetBytes("P6\n2 1\n255\n12345")));

    private static Picture OfOnePixel(byte blue) => Picture.FromPpm([.. Encoding.ASCII.GetBytes("P6\n1 1\n255\n"), 1, 2, blue]);
}
