using System.Globalization;
using System.Net;
using System.Net.WebSockets;
using NeuronMocap.AspNetCore.Tests.Infrastructure;

namespace NeuronMocap.AspNetCore.Tests.WebSockets;

// Which requests are accepted, and what the others are told.
public sealed class WebSocketRequestTests
{
    private static readonly WebSocketBroadcasterOptions Guarded = new() { Token = "wörd", AllowedOrigins = ["https://show.example", "https://bühne.example", "null"] };

    [Theory]
    [InlineData(401, "The token is missing or wrong.")]
    [InlineData(401, "The token is missing or wrong.", "?token=Word")]
    [InlineData(401, "The token is missing or wrong.", "?token=")]
    [InlineData(401, "The token is missing or wrong.", "", "Authorization", "Bearer other")]
    [InlineData(403, "The server does not allow pages of this origin.", "?token=w%C3%B6rd", "Origin", "https://evil.example")]
    [InlineData(403, "The server does not allow pages of this origin.", "?token=w%C3%B6rd", "Origin", "http://localhost.evil.example")]
    [InlineData(403, "The server does not allow pages of this origin.", "?token=w%C3%B6rd", "Origin", "http://show.example")]
    [InlineData(403, "The server does not allow pages of this origin.", "?token=w%C3%B6rd", "Origin", "https://user@show.example")]
    [InlineData(400, "None of the subprotocols is known. Use json, packet or pose.", "?token=w%C3%B6rd", "Sec-WebSocket-Protocol", "mqtt, JSON")]
    [InlineData(400, "The rate is not a number from 0.01 to 1000.", "?token=w%C3%B6rd&rate=0")]
    [InlineData(400, "The rate is not a number from 0.01 to 1000.", "?token=w%C3%B6rd&rate=NaN")]
    [InlineData(400, "The rate is not a number from 0.01 to 1000.", "?token=w%C3%B6rd&rate=fast")]
    public async Task A_wrong_request_gets_a_status_and_a_sentence(int status, string sentence, string query = "", string? header = null, string value = "")
    {
        await using MotionSite site = await MotionSite.StartAsync(Guarded);
        using var http = new HttpClient();
        using var request = new HttpRequestMessage(HttpMethod.Get, site.Address.Replace("ws:", "http:", StringComparison.Ordinal) + query);
        request.Headers.TryAddWithoutValidation("Connection", "Upgrade");
        request.Headers.TryAddWithoutValidation("Upgrade", "websocket");
        request.Headers.TryAddWithoutValidation("Sec-WebSocket-Version", "13");
        request.Headers.TryAddWithoutValidation("Sec-WebSocket-Key", "AAAAAAAAAAAAAAAAAAAAAA==");
        if (header is not null)
            request.Headers.TryAddWithoutValidation(header, value);

        using HttpResponseMessage response = await http.SendAsync(request, TestContext.Current.CancellationToken).Soon();
        Assert.Equal(status, (int)response.StatusCode);
        Assert.StartsWith(sentence, await response.Content.ReadAsStringAsync(TestContext.Current.CancellationToken), StringComparison.Ordinal);
        Assert.Equal(status == 401, response.Headers.WwwAuthenticate.Count == 1);
        Assert.Equal((0, 1), (site.Broadcaster.GetStatistics().Clients, site.Broadcaster.GetStatistics().Refused));
    }

    [Fact]
    public async Task A_browser_that_opens_the_address_is_told_what_it_is()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using var http = new HttpClient();
        using HttpResponseMessage response = await http.GetAsync(new Uri(site.Address.Replace("ws:", "http:", StringComparison.Ordinal)), TestContext.Current.CancellationToken).Soon();
        Assert.Equal(HttpStatusCode.BadRequest, response.StatusCode);
        Assert.Equal("This address sends motion to WebSocket clients. Connect with ws:// or wss://.\n", await response.Content.ReadAsStringAsync(TestContext.Current.CancellationToken));
    }

    [Theory]
    [InlineData("?token=w%C3%B6rd", null)]
    [InlineData("?token=w%C3%B6rd", "https://show.example")]
    [InlineData("?token=w%C3%B6rd", "https://show.example:443")]
    [InlineData("?token=w%C3%B6rd", "https://xn--bhne-0ra.example")]
    [InlineData("?token=w%C3%B6rd", "null")]
    [InlineData("?token=w%C3%B6rd", "http://localhost:8080")]
    [InlineData("?token=w%C3%B6rd", "http://127.0.0.1")]
    [InlineData("?token=w%C3%B6rd", "https://[::1]:5001")]
    public async Task An_allowed_client_is_served(string query, string? origin)
    {
        await using MotionSite site = await MotionSite.StartAsync(Guarded);
        using ClientWebSocket client = await site.ConnectAsync("pose", query, options =>
        {
            if (origin is not null)
                options.SetRequestHeader("Origin", origin);
        });
        Assert.Equal(WebSocketState.Open, client.State);
    }

    [Theory]
    [InlineData("https://show.example:443", "https://show.example")]
    [InlineData("http://show.example:80", "http://show.example")]
    [InlineData("https://SHOW.example:443/", "https://show.example:443")]
    [InlineData("chrome-extension://abc", "chrome-extension://abc")]
    public async Task An_origin_can_be_written_in_several_ways(string allowed, string origin)
    {
        await using MotionSite site = await MotionSite.StartAsync(new() { AllowedOrigins = [allowed] });
        using ClientWebSocket client = await site.ConnectAsync("pose", configure: options => options.SetRequestHeader("Origin", origin));
        Assert.Equal(WebSocketState.Open, client.State);
    }

    [Theory]
    [InlineData("https://user@show.example")]
    [InlineData("show.example")]
    [InlineData("https://show.example/page")]
    [InlineData("https://show.example:443/page")]
    [InlineData("https://show.example/.")]
    [InlineData("https://show.example?page")]
    [InlineData("https://show.example/?")]
    [InlineData("https://show.example#page")]
    [InlineData("https://show.example/#")]
    [InlineData(" https://show.example")]
    [InlineData(null)]
    public void An_origin_is_a_scheme_a_host_and_a_port(string? origin)
    {
        using var reader = new NeuronReader("127.0.0.1", 1);
        string message = Assert.Throws<ArgumentException>(() => new WebSocketBroadcaster(reader, new() { AllowedOrigins = ["*", origin!] })).Message;
        Assert.StartsWith(origin is null ? "AllowedOrigins contains a null reference" : $"AllowedOrigins contains '{origin}'", message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_first_known_subprotocol_counts()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using ClientWebSocket client = await site.ConnectAsync("mqtt", configure: static options =>
        {
            options.AddSubProtocol("pose");
            options.AddSubProtocol("json");
        });
        Assert.Equal("pose", client.SubProtocol);
        Assert.Equal(WebSocketForm.Pose, Assert.Single(site.Broadcaster.GetClients()).Form);
    }

    [Fact]
    public async Task A_full_server_refuses_until_a_client_leaves()
    {
        const int Rounds = 20;
        await using MotionSite site = await MotionSite.StartAsync(new WebSocketBroadcasterOptions { MaxClients = 1 });
        ClientWebSocket client = await site.ConnectAsync();
        using var second = new ClientWebSocket();
        WebSocketException exception = await Assert.ThrowsAsync<WebSocketException>(() => second.ConnectAsync(new Uri(site.Address), TestContext.Current.CancellationToken).Soon());
        Assert.Contains("503", exception.Message, StringComparison.Ordinal);

        // Often, because a place that is freed too late shows only now and then.
        for (int i = 0; i < Rounds; i++)
        {
            await client.CloseAsync(WebSocketCloseStatus.NormalClosure, null, TestContext.Current.CancellationToken).Soon();
            client.Dispose();
            await Limits.UntilAsync(() => site.Broadcaster.GetStatistics().Clients == 0);
            client = await site.ConnectAsync();
        }

        WebSocketBroadcasterStatistics statistics = site.Broadcaster.GetStatistics();
        client.Dispose();
        Assert.Equal((1, 1 + Rounds, 1), (statistics.Clients, statistics.Accepted, statistics.Refused));
    }

    [Fact]
    public async Task Wrong_options_are_named()
    {
        await using var reader = new NeuronReader("127.0.0.1", 1);
        Assert.StartsWith("Token is empty", Fault(new() { Token = string.Empty }), StringComparison.Ordinal);
        Assert.StartsWith("Token has spaces at its start or end", Fault(new() { Token = "word " }), StringComparison.Ordinal);
        Assert.StartsWith("MaxClients is 0", Fault(new() { MaxClients = 0 }), StringComparison.Ordinal);
        Assert.StartsWith("MaxRate is NaN", Fault(new() { MaxRate = double.NaN }), StringComparison.Ordinal);
        Assert.StartsWith("ClientTimeout is 00:00:00", Fault(new() { ClientTimeout = TimeSpan.Zero }), StringComparison.Ordinal);
        Assert.Throws<ArgumentNullException>(() => new WebSocketBroadcaster(null!));

        string Fault(WebSocketBroadcasterOptions options) => Assert.Throws<ArgumentException>(() => new WebSocketBroadcaster(reader, options)).Message;
    }

    [Fact]
    public void A_message_about_an_option_does_not_depend_on_the_culture()
    {
        using var reader = new NeuronReader("127.0.0.1");
        CultureInfo before = CultureInfo.CurrentCulture;
        try
        {
            CultureInfo.CurrentCulture = new CultureInfo(string.Empty) { NumberFormat = { NumberDecimalSeparator = "," } };
            string message = Assert.Throws<ArgumentException>(() => new WebSocketBroadcaster(reader, new() { MaxRate = 0.001 })).Message;
            Assert.StartsWith("MaxRate is 0.001;", message, StringComparison.Ordinal);
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }
    }

    [Fact]
    public async Task A_reader_that_was_disposed_gives_nothing_to_broadcast()
    {
        var reader = new NeuronReader("127.0.0.1");
        await reader.DisposeAsync();

        await using var broadcaster = new WebSocketBroadcaster(reader);

        await broadcaster.Completion.Soon();
    }
}
