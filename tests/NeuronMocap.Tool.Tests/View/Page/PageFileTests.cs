using System.IO.Compression;
using System.Net;

namespace NeuronMocap.Tool.Tests.View.Page;

// How the server sends the files of the page.
public sealed class PageFileTests
{
    public PageFileTests() => Assert.SkipUnless(NodeProgram.Exists, "Without Node, the program is built without the page.");

    [Theory]
    [InlineData("/app.js", "text/javascript")]
    [InlineData("/app.css", "text/css")]
    [InlineData("/licenses.txt", "text/plain")]
    [InlineData("/", "text/html")]
    public async Task A_file_is_compressed_for_those_who_take_that(string path, string type)
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        using HttpResponseMessage plain = await SendAsync(view, path);
        using HttpResponseMessage compressed = await SendAsync(view, path, "gzip, deflate, br");
        using HttpResponseMessage refused = await SendAsync(view, path, "br, gzip;q=0");
        Assert.Empty(plain.Content.Headers.ContentEncoding);
        Assert.Empty(refused.Content.Headers.ContentEncoding);
        Assert.Equal(["gzip"], compressed.Content.Headers.ContentEncoding);
        foreach (HttpResponseMessage answer in (HttpResponseMessage[])[plain, compressed, refused])
        {
            Assert.Equal(HttpStatusCode.OK, answer.StatusCode);
            Assert.Equal(type, answer.Content.Headers.ContentType!.MediaType);
            Assert.Equal(["Accept-Encoding"], answer.Headers.Vary);
            Assert.True(answer.Headers.Contains("Content-Security-Policy"));
        }

        byte[] wanted = await plain.Content.ReadAsByteArrayAsync(TestContext.Current.CancellationToken);
        await using var unpacked = new GZipStream(await compressed.Content.ReadAsStreamAsync(TestContext.Current.CancellationToken), CompressionMode.Decompress);
        using var bytes = new MemoryStream();
        await unpacked.CopyToAsync(bytes, TestContext.Current.CancellationToken);
        Assert.NotEmpty(wanted);
        Assert.Equal(wanted, bytes.ToArray());
        Assert.Equal(wanted, await refused.Content.ReadAsByteArrayAsync(TestContext.Current.CancellationToken));
    }

    [Fact]
    public async Task A_browser_that_has_a_file_gets_it_only_in_another_form()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        using HttpResponseMessage first = await SendAsync(view, "/app.js", "gzip");
        string tag = first.Headers.ETag!.Tag;
        Assert.Equal("no-cache", first.Headers.CacheControl!.ToString());
        using HttpResponseMessage second = await SendAsync(view, "/app.js", "gzip", tag);
        Assert.Equal(HttpStatusCode.NotModified, second.StatusCode);
        Assert.Empty(await second.Content.ReadAsByteArrayAsync(TestContext.Current.CancellationToken));
        using HttpResponseMessage among = await SendAsync(view, "/app.js", "gzip", $"\"other\", W/{tag}");
        Assert.Equal(HttpStatusCode.NotModified, among.StatusCode);
        using HttpResponseMessage plain = await SendAsync(view, "/app.js", string.Empty, tag);
        Assert.Equal(HttpStatusCode.OK, plain.StatusCode);
    }

    [Fact]
    public async Task The_scripts_of_the_page_need_no_question_because_their_names_change()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        string page = await view.Client.GetStringAsync("/", TestContext.Current.CancellationToken);
        string[] scripts = [.. page.Split("modulepreload\" href=\"").Skip(1).Select(static rest => rest.Split('"')[0])];
        Assert.NotEmpty(scripts);
        Assert.DoesNotContain(scripts, static script => script.StartsWith("load", StringComparison.Ordinal));
        foreach (string script in scripts)
        {
            using HttpResponseMessage answer = await SendAsync(view, "/" + script, "gzip");
            Assert.Equal(HttpStatusCode.OK, answer.StatusCode);
            Assert.Contains("immutable", answer.Headers.CacheControl!.ToString(), StringComparison.Ordinal);
        }
    }

    [Fact]
    public async Task Head_tells_the_length_without_the_contents()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        foreach (string encoding in (string[])[string.Empty, "gzip"])
        {
            using HttpResponseMessage whole = await SendAsync(view, "/app.css", encoding);
            using HttpResponseMessage head = await SendAsync(view, "/app.css", encoding, method: HttpMethod.Head);
            byte[] contents = await whole.Content.ReadAsByteArrayAsync(TestContext.Current.CancellationToken);
            Assert.Equal(contents.Length, head.Content.Headers.ContentLength);
            Assert.Equal(whole.Headers.ETag, head.Headers.ETag);
            Assert.Empty(await head.Content.ReadAsByteArrayAsync(TestContext.Current.CancellationToken));
        }
    }

    private static async Task<HttpResponseMessage> SendAsync(RunningView view, string path, string encoding = "", string? tag = null, HttpMethod? method = null)
    {
        using var request = new HttpRequestMessage(method ?? HttpMethod.Get, path);
        if (encoding.Length > 0)
            request.Headers.Add("Accept-Encoding", encoding);
        if (tag is not null)
            request.Headers.TryAddWithoutValidation("If-None-Match", tag);
        return await view.Client.SendAsync(request, TestContext.Current.CancellationToken).Soon();
    }
}
