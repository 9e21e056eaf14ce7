using System.Net;
using System.Net.Sockets;
using System.Net.WebSockets;
using System.Text;
using System.Text.Json;

namespace NeuronMocap.Tool.Tests.View;

// Who may use the server, and what requests cannot do.
public sealed class ViewAccessTests
{
    [Theory]
    [InlineData("/api/hello")]
    [InlineData("/api/record")]
    [InlineData("/api/takes/1")]
    [InlineData("/nothing")]
    public async Task Without_the_token_there_is_nothing_but_the_page(string path)
    {
        await using RunningView view = await RunningView.StartAsync("demo", "--token", "right");
        Assert.Equal("?token=right", view.Link.Query);
        using var client = new HttpClient { BaseAddress = view.Client.BaseAddress };
        Assert.Equal(HttpStatusCode.Unauthorized, await GetStatusAsync(client, path));
        Assert.Equal(HttpStatusCode.Unauthorized, await GetStatusAsync(client, $"{path}?token=wrong"));
        Assert.Equal(HttpStatusCode.Unauthorized, await GetStatusAsync(client, $"{path}?token="));
        client.DefaultRequestHeaders.Add("Authorization", "Bearer wrong");
        Assert.Equal(HttpStatusCode.Unauthorized, await GetStatusAsync(client, path));
        Assert.NotEqual(HttpStatusCode.Unauthorized, await GetStatusAsync(client, "/"));
        Assert.NotEqual(HttpStatusCode.Unauthorized, await GetStatusAsync(client, "/app.js"));
    }

    [Theory]
    [InlineData("The token is not that of the running program.", "--token", "right")]
    [InlineData("The token is not that of the running program. Each start of the program makes a new one.", "--bind", "0.0.0.0")]
    public async Task A_wrong_token_is_explained(string expected, params string[] options)
    {
        await using RunningView view = await RunningView.StartAsync(["demo", .. options]);
        using var client = new HttpClient { BaseAddress = view.Client.BaseAddress };
        using HttpResponseMessage answer = await client.GetAsync("/api/hello?token=wrong", TestContext.Current.CancellationToken).Soon();
        string text = await answer.Content.ReadAsStringAsync(TestContext.Current.CancellationToken);
        Assert.Equal(expected, JsonDocument.Parse(text).RootElement.GetProperty("error").GetString());
    }

    [Fact]
    public async Task The_token_comes_in_the_header_or_in_the_query()
    {
        await using RunningView view = await RunningView.StartAsync("demo", "--token", "right");
        using var client = new HttpClient { BaseAddress = view.Client.BaseAddress };
        Assert.Equal(HttpStatusCode.OK, await GetStatusAsync(client, "/api/hello?token=right"));
        Assert.Equal(HttpStatusCode.OK, await GetStatusAsync(view.Client, "/api/hello"));
        using ViewSocket control = await view.ConnectAsync("/control");
        await control.FindAsync("hello");
    }

    [Theory]
    [InlineData("/control")]
    [InlineData("/motion")]
    public async Task Sockets_need_the_token_and_a_page_of_this_server(string path)
    {
        await using RunningView view = await RunningView.StartAsync("demo", "--token", "right");
        var address = new UriBuilder(view.Link) { Scheme = "ws", Path = path, Query = string.Empty };
        await Assert.ThrowsAsync<WebSocketException>(() => ViewSocket.ConnectAsync(address.Uri, subprotocol: null, configure: null));
        await Assert.ThrowsAsync<WebSocketException>(() => view.ConnectAsync(path, configure: static options => options.SetRequestHeader("Origin", "https://evil.example")));
        using ViewSocket own = await view.ConnectAsync(path, configure: options => options.SetRequestHeader("Origin", view.Link.GetLeftPart(UriPartial.Authority)));
        Assert.Equal(WebSocketState.Open, own.State);
    }

    [Fact]
    public async Task An_address_for_other_computers_always_has_a_token()
    {
        await using RunningView view = await RunningView.StartAsync("demo", "--bind", "0.0.0.0");
        Assert.Matches("^\\?token=[0-9a-f]{32}$", view.Link.Query);
        using var client = new HttpClient { BaseAddress = view.Client.BaseAddress };
        Assert.Equal(HttpStatusCode.Unauthorized, await GetStatusAsync(client, "/api/hello"));
        Assert.Equal(HttpStatusCode.OK, await GetStatusAsync(view.Client, "/api/hello"));
    }

    [Theory]
    [InlineData("evil.example", 421)]
    [InlineData("127.0.0.1.evil.example", 421)]
    [InlineData("localhost.evil.example:7080", 421)]
    [InlineData("192.168.1.20", 421)]
    [InlineData("localhost", 200)]
    [InlineData("LOCALHOST:1", 200)]
    [InlineData("[::1]:7080", 200)]
    [InlineData("127.0.0.2", 200)]
    public async Task Only_names_of_this_computer_are_answered(string host, int expected)
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        foreach (string path in (string[])["/api/hello", "/api/hello?token=x"])
        {
            using var request = new HttpRequestMessage(HttpMethod.Get, path);
            request.Headers.Host = host;
            using HttpResponseMessage answer = await view.Client.SendAsync(request, TestContext.Current.CancellationToken).Soon();
            Assert.Equal(expected, (int)answer.StatusCode);
        }
    }

    [Fact]
    public async Task A_proxy_shows_the_page_under_its_own_address()
    {
        await using RunningView view = await RunningView.StartAsync("demo", "--allow-origin", "https://show.example");
        const string Start = "From other computers and phones: ";
        Assert.Equal($"{Start}https://show.example/{view.Link.Query}", await view.FindLineAsync(Start));
        Assert.Matches("^\\?token=[0-9a-f]{32}$", view.Link.Query);
        using var request = new HttpRequestMessage(HttpMethod.Get, "/api/hello");
        request.Headers.Host = "show.example";
        request.Headers.Add("Origin", "https://show.example");
        using HttpResponseMessage answer = await view.Client.SendAsync(request, TestContext.Current.CancellationToken).Soon();
        Assert.Equal(HttpStatusCode.OK, answer.StatusCode);
    }

    [Fact]
    public async Task The_page_itself_is_not_served_to_a_foreign_name()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        using var request = new HttpRequestMessage(HttpMethod.Get, "/");
        request.Headers.Host = "evil.example";
        using HttpResponseMessage answer = await view.Client.SendAsync(request, TestContext.Current.CancellationToken).Soon();
        Assert.Equal(421, (int)answer.StatusCode);
    }

    [Theory]
    [InlineData("localhost", true)]
    [InlineData("127.0.0.1", true)]
    [InlineData("[::1]", true)]
    [InlineData("192.0.2.7", false)]
    public async Task The_opener_policy_is_only_for_pages_where_browsers_accept_it(string host, bool expected)
    {
        await using RunningView view = await RunningView.StartAsync("demo", "--bind", "0.0.0.0");
        using var request = new HttpRequestMessage(HttpMethod.Get, "/");
        request.Headers.Host = host;
        using HttpResponseMessage answer = await view.Client.SendAsync(request, TestContext.Current.CancellationToken).Soon();
        Assert.Equal(expected, answer.Headers.Contains("Cross-Origin-Opener-Policy"));
    }

    [Theory]
    [InlineData("Origin", "https://evil.example", 403)]
    [InlineData("Origin", "null", 403)]
    [InlineData("Sec-Fetch-Site", "cross-site", 403)]
    [InlineData("Sec-Fetch-Site", "same-site", 403)]
    [InlineData("Sec-Fetch-Site", "same-origin", 200)]
    [InlineData("Sec-Fetch-Site", "none", 200)]
    [InlineData("Origin", "http://localhost:3000", 403)]
    public async Task Pages_of_other_sites_are_refused(string header, string value, int expected)
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        using var request = new HttpRequestMessage(HttpMethod.Get, "/api/hello");
        request.Headers.Add(header, value);
        using HttpResponseMessage answer = await view.Client.SendAsync(request, TestContext.Current.CancellationToken).Soon();
        Assert.Equal(expected, (int)answer.StatusCode);
        Assert.False(answer.Headers.Contains("Access-Control-Allow-Origin"));
    }

    [Fact]
    public async Task Answers_forbid_other_origins_and_guessed_types()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        foreach (string path in (string[])["/", "/api/hello", "/missing"])
        {
            using HttpResponseMessage answer = await view.Client.GetAsync(path, TestContext.Current.CancellationToken).Soon();
            string policy = Assert.Single(answer.Headers.GetValues("Content-Security-Policy"));
            Assert.StartsWith("default-src 'none'; script-src 'self'; ", policy, StringComparison.Ordinal);
            Assert.DoesNotContain("http", policy, StringComparison.Ordinal);
            Assert.DoesNotContain("unsafe", policy, StringComparison.Ordinal);
            Assert.Equal("nosniff", Assert.Single(answer.Headers.GetValues("X-Content-Type-Options")));
            Assert.Equal("no-referrer", Assert.Single(answer.Headers.GetValues("Referrer-Policy")));
            Assert.False(answer.Headers.Contains("Server"));
        }
    }

    // HttpClient would shorten these paths.
    [Theory]
    [InlineData("/../../etc/passwd")]
    [InlineData("/%2e%2e/%2e%2e/etc/passwd")]
    [InlineData("/..%2f..%2fetc%2fpasswd")]
    [InlineData("/app.js/../api/hello")]
    [InlineData("/app.js/%2e%2e/api/hello")]
    [InlineData("//api/hello")]
    [InlineData("/API/Hello")]
    [InlineData("/api/hello/")]
    [InlineData("/web/index.html/../../api/hello")]
    [InlineData("/api/performers/..%2f..%2fetc%2fpasswd/figure.glb")]
    [InlineData("http://evil.example/app.js")]
    public async Task No_path_leads_around_the_token_or_to_files(string path)
    {
        await using RunningView view = await RunningView.StartAsync("demo", "--token", "right");
        string answer = await SendRawAsync(view.Link, $"GET {path} HTTP/1.1\r\nHost: {view.Link.Authority}\r\nConnection: close\r\n\r\n");
        Assert.Matches("^HTTP/1.1 (400|401|404|421) ", answer);
        Assert.DoesNotContain("root:", answer, StringComparison.Ordinal);
        Assert.DoesNotContain("\"performers\"", answer, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_body_that_is_too_large_is_refused_with_a_sentence()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        (int status, JsonElement answer) = await view.PostAsync("/api/record", $$"""{"action":"{{new string('x', 100_000)}}"}""");
        Assert.Equal(413, status);
        Assert.Equal("The body of the request is larger than 64 kB.", answer.GetProperty("error").GetString());
    }

    [Fact]
    public async Task Errors_are_sentences_in_JSON()
    {
        await using RunningView view = await RunningView.StartAsync("demo");
        Assert.Equal("There is nothing at this address.", (await view.GetAsync("/api/nothing")).GetProperty("error").GetString());
        (int status, JsonElement answer) = await view.PostAsync("/api/hello");
        Assert.Equal(405, status);
        Assert.Equal("This address does not know the method of the request.", answer.GetProperty("error").GetString());
        Assert.Equal("This address is a WebSocket.", (await view.GetAsync("/control")).GetProperty("error").GetString());
    }

    private static async Task<HttpStatusCode> GetStatusAsync(HttpClient client, string path)
    {
        using HttpResponseMessage answer = await client.GetAsync(path, TestContext.Current.CancellationToken).Soon();
        return answer.StatusCode;
    }

    private static async Task<string> SendRawAsync(Uri server, string request)
    {
        using var socket = new Socket(SocketType.Stream, ProtocolType.Tcp);
        await socket.ConnectAsync(IPAddress.Loopback, server.Port, TestContext.Current.CancellationToken);
        await socket.SendAsync(Encoding.ASCII.GetBytes(request), TestContext.Current.CancellationToken);
        using var reader = new StreamReader(new NetworkStream(socket), Encoding.UTF8);
        return await reader.ReadToEndAsync(TestContext.Current.CancellationToken).Soon();
    }
}
