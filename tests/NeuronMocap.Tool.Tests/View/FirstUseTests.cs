using System.Text;
using NeuronMocap.Tool.View;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.Tests.View;

public sealed class FirstUseTests
{
    // The program does not wait for it, so nobody would see that it fails.
    [Fact]
    public async Task What_the_first_page_needs_is_made_without_a_fault() => await FirstUse.RunAsync().Soon();

    [Fact]
    public async Task The_page_is_sent_as_to_a_browser()
    {
        string answer = Encoding.Latin1.GetString(await FirstUse.RequestPageAsync().Soon());
        Assert.StartsWith(PageFiles.Exist ? "HTTP/1.1 200 OK" : "HTTP/1.1 404 Not Found", answer, StringComparison.Ordinal);
    }
}
