using System.Text;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

public sealed class NumericTextTests
{
    [Theory]
    [InlineData("0 Char00 0.00 93.02 0.00 -1.5", true)]
    [InlineData("0 Char00 0.00 93.02 || \r\n0 Char00 0.1 0.2", true)]
    [InlineData("0 Char00 0.00 93.02||1 Char01 0.00 93.02 0", true)]
    [InlineData("\0\00 名前 1.5 2.5 3.5", true)]
    [InlineData("1.5 -2.5 3.5e-05 4.5\n1.6", true)]
    [InlineData("3.02 0.00 || \r\n1 Zoe 2.5 ", true)]
    [InlineData("SSH-2.0-OpenSSH_9.6p1\r\n", false)]
    [InlineData("HTTP/1.1 400 Bad Request\r\n", false)]
    [InlineData("5.7.42-log and more words 1 2 3", false)]
    [InlineData("hello 1 2 3 ", false)]
    [InlineData("1 2\u0007 3 ", false)]
    [InlineData("17", false)]
    [InlineData("", false)]
    public void Only_numbers_with_a_name_in_second_place_are_the_text_format(string text, bool expected) =>
        Assert.Equal(expected, NumericText.IsAt(Encoding.UTF8.GetBytes(text)));
}
