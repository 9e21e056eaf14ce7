using System.Diagnostics;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Http.Features;

namespace NeuronMocap.AspNetCore;

/// <summary>What a client sends: a stream between Kestrel and the WebSocket, which counts the bytes of frames that are no messages, too.</summary>
/// <remarks>A WebSocket answers pings by itself, so a flood of them shows only here. Once a client has sent too much, nothing more is read.</remarks>
internal sealed class LimitedInput : IDisposable
{
    /// <summary>Bytes that a client may send in a second.</summary>
    public const int MostBytes = 16 * 1024;

    private readonly CancellationTokenSource _end = new();
    private long _second = Stopwatch.GetTimestamp();
    private int _bytes;

    /// <summary>Called once, when a client has sent too much.</summary>
    public Action? Exceeded { get; set; }

    /// <summary>Puts the stream below the WebSocket of a request, and itself among the features. Precedes the middleware for WebSockets.</summary>
    public static Task InsertAsync(HttpContext context, RequestDelegate next)
    {
        var input = new LimitedInput();
        context.Features.Set(input);

        // The application may use the middleware as well. Its feature would bypass the stream.
        context.Features.Set<IHttpWebSocketFeature>(null);
        if (context.Features.Get<IHttpUpgradeFeature>() is { } upgrade)
            context.Features.Set<IHttpUpgradeFeature>(new Upgrade(upgrade, input));
        if (context.Features.Get<IHttpExtendedConnectFeature>() is { } connect)
            context.Features.Set<IHttpExtendedConnectFeature>(new ExtendedConnect(connect, input));

        return next(context);
    }

    /// <summary>Ends a pending read and all later ones. The connection stays open.</summary>
    public void End() => _end.Cancel();

    public void Dispose() => _end.Dispose();

    // A read of the WebSocket has no token. Two tokens need a source that joins them.
    private ValueTask<int> ReadAsync(Stream stream, Memory<byte> buffer, CancellationToken cancellationToken) =>
        cancellationToken.CanBeCanceled ? ReadJoinedAsync(stream, buffer, cancellationToken) : ReadLimitedAsync(stream, buffer, _end.Token);

    private async ValueTask<int> ReadJoinedAsync(Stream stream, Memory<byte> buffer, CancellationToken cancellationToken)
    {
        using var either = CancellationTokenSource.CreateLinkedTokenSource(_end.Token, cancellationToken);
        return await ReadLimitedAsync(stream, buffer, either.Token).ConfigureAwait(false);
    }

    private async ValueTask<int> ReadLimitedAsync(Stream stream, Memory<byte> buffer, CancellationToken cancellationToken)
    {
        if (_bytes > MostBytes)
            await Task.Delay(Timeout.Infinite, cancellationToken).ConfigureAwait(false);

        int count = await stream.ReadAsync(buffer, cancellationToken).ConfigureAwait(false);
        if (Stopwatch.GetElapsedTime(_second) > TimeSpan.FromSeconds(1))
            (_second, _bytes) = (Stopwatch.GetTimestamp(), 0);

        _bytes += count;
        if (_bytes > MostBytes)
            Exceeded?.Invoke();

        return count;
    }

    private sealed class Upgrade(IHttpUpgradeFeature inner, LimitedInput input) : IHttpUpgradeFeature
    {
        public bool IsUpgradableRequest => inner.IsUpgradableRequest;

        public async Task<Stream> UpgradeAsync() => new InputStream(await inner.UpgradeAsync().ConfigureAwait(false), input);
    }

    private sealed class ExtendedConnect(IHttpExtendedConnectFeature inner, LimitedInput input) : IHttpExtendedConnectFeature
    {
        public bool IsExtendedConnect => inner.IsExtendedConnect;

        public string? Protocol => inner.Protocol;

        public async ValueTask<Stream> AcceptAsync() => new InputStream(await inner.AcceptAsync().ConfigureAwait(false), input);
    }

    // The WebSocket of ASP.NET Core only reads and writes asynchronously; Kestrel refuses blocking calls too. A connection has no length and no position, and
    // throws what the contract of Stream asks for when CanSeek is false.
    private sealed class InputStream(Stream inner, LimitedInput input) : Stream
    {
        private const string OnlyAsynchronous = "The connection reads and writes only asynchronously.";
        private const string NoPosition = "A connection has no length and no position.";

        public override bool CanRead => true;

        public override bool CanSeek => false;

        public override bool CanWrite => true;

        public override long Length => throw new NotSupportedException(NoPosition);

        public override long Position
        {
            get => throw new NotSupportedException(NoPosition);
            set => throw new NotSupportedException(NoPosition);
        }

        public override ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellationToken = default) => input.ReadAsync(inner, buffer, cancellationToken);

        public override ValueTask WriteAsync(ReadOnlyMemory<byte> buffer, CancellationToken cancellationToken = default) => inner.WriteAsync(buffer, cancellationToken);

        public override Task FlushAsync(CancellationToken cancellationToken) => inner.FlushAsync(cancellationToken);

        public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException(OnlyAsynchronous);

        public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException(OnlyAsynchronous);

        public override void Flush() => throw new NotSupportedException(OnlyAsynchronous);

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException(NoPosition);

        public override void SetLength(long value) => throw new NotSupportedException(NoPosition);

        protected override void Dispose(bool disposing)
        {
            if (disposing)
                inner.Dispose();

            base.Dispose(disposing);
        }
    }
}
