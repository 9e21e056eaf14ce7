using System.Collections.Concurrent;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Commands;

// Asks a server's command channel for format and bodies, on behalf of one reader. Each question goes to the server once per connection of the reader, and
// all callers share the answer. Questions end with an ObjectDisposedException when this object is disposed. Any thread.
internal sealed class ServerInquiry(NeuronCommandOptions options) : IDisposable
{
    private readonly NeuronCommandClient _client = new(options);

    // The token sources are never disposed: they have no timers, and running requests still use them.
    private volatile Answers _answers = new(new CancellationTokenSource());

    // Forgets all answers, because the reader has a new connection, perhaps to another server. Waiting callers get the answer of the new server.
    public void Renew() => Interlocked.Exchange(ref _answers, new Answers(new CancellationTokenSource())).Cancel();

    // Each of these methods asks again if the server gave no answer; on a retry, also after any other failure.
    public Task<RotationOrder> GetRotationOrderAsync(bool isRetry) =>
        GetAsync(answers => answers.Orders, avatarIndex: 0, (_, cancellationToken) => _client.GetRotationOrderAsync(cancellationToken), isRetry);

    public Task<BvhSkeletonMap> GetSkeletonAsync(int avatarIndex, bool isRetry) =>
        GetAsync(answers => answers.Skeletons, avatarIndex, AskSkeletonAsync, isRetry);

    public Task<BoneDimensions> GetDimensionsAsync(int avatarIndex, bool isRetry) =>
        GetAsync(answers => answers.Dimensions, avatarIndex, _client.GetBoneDimensionsAsync, isRetry);

    // Prefers the header, which contains more than the twelve sizes.
    public async Task<BodyAnswer> GetBodyAsync(int avatarIndex, bool isRetry)
    {
        try
        {
            return new BodyAnswer(await GetSkeletonAsync(avatarIndex, isRetry).ConfigureAwait(false), default);
        }
        catch (NeuronCommandException exception) when (exception.IsAnswer)
        {
            return new BodyAnswer(Skeleton: null, await GetDimensionsAsync(avatarIndex, isRetry).ConfigureAwait(false));
        }
    }

    // Returns at once.
    public void Dispose() => _ = _client.DisposeAsync().AsTask();

    private async Task<BvhSkeletonMap> AskSkeletonAsync(int avatarIndex, CancellationToken cancellationToken)
    {
        BvhDocument header = await _client.GetBvhHeaderAsync(avatarIndex, cancellationToken).ConfigureAwait(false);
        return BvhSkeletonMap.TryCreate(header, out BvhSkeletonMap? map, out string? reason)
            ? map
            : throw new NeuronCommandException(CommandFailure.InvalidReply, $"The BVH header of avatar {avatarIndex} has another skeleton: {reason}");
    }

    private async Task<T> GetAsync<T>(
        Func<Answers, ConcurrentDictionary<int, SharedAnswer<T>>> choose, int avatarIndex, Func<int, CancellationToken, Task<T>> ask, bool isRetry)
    {
        while (true)
        {
            Answers answers = _answers;
            try
            {
                SharedAnswer<T> answer = choose(answers).GetOrAdd(avatarIndex, avatar => new SharedAnswer<T>(() => ask(avatar, answers.CancellationToken)));
                return await answer.GetAsync(isRetry).ConfigureAwait(false);
            }
            catch (OperationCanceledException) when (answers.CancellationToken.IsCancellationRequested)
            {
                // The answer belongs to a connection that has ended; ask again.
            }
        }
    }

    // The answers of one connection of the reader.
    private sealed class Answers(CancellationTokenSource stopSource)
    {
        public CancellationToken CancellationToken => stopSource.Token;

        public ConcurrentDictionary<int, SharedAnswer<RotationOrder>> Orders { get; } = new();

        public ConcurrentDictionary<int, SharedAnswer<BvhSkeletonMap>> Skeletons { get; } = new();

        public ConcurrentDictionary<int, SharedAnswer<BoneDimensions>> Dimensions { get; } = new();

        public void Cancel() => stopSource.Cancel();
    }
}
