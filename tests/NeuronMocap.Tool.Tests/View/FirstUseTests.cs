using System.Net;
using System.Text;
using NeuronMocap.Tool.View;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.Tests.View;

public sealed class FirstUseTests
{
    private static readonly IPEndPoint Unused = new(IPAddress.Loopback, 0);

    // The program does not wait for it, so nobody would see that it fails. The second address belongs to no computer.
    [Theory]
    [InlineData("127.0.0.1")]
    [InlineData("192.0.2.1")]
    public async Task What_the_first_page_needs_is_made_without_a_fault(string address) => await FirstUse.RunAsync(new IPEndPoint(IPAddress.Parse(address), 0)).Soon();

    [Fact]
    public async Task The_page_is_sent_as_to_a_browser()
    {
        string answer = Encoding.Latin1.GetString(await FirstUse.RequestPageAsync(Unused).Soon());
        Assert.StartsWith(PageFiles.Exist ? "HTTP/1.1 200 OK" : "HTTP/1.1 404 Not Found", answer, StringComparison.Ordinal);
    }
}
