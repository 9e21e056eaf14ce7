using System.Collections.Concurrent;
using System.Diagnostics;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Frames;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Reader;

// Learns from the server's command channel what an Axis Neuron stream does not say: the order of the rotation values; the variant of the skeleton, from
// the names in the BVH header; and the sizes of bodies, where somebody wants them. It asks on every connection of the reader and repeats what failed,
// less and less often. What it learns about the format, or why it learnt nothing, becomes part of the status message. Nothing waits for it. Any thread.
internal sealed class ServerDiscovery(NeuronCommandOptions options, FrameFormat format, Action learnt) : IDisposable
{
    // Whoever switches the command channel on while frames arrive does not want to start the reader anew.
    private static readonly long FirstRetry = 5 * Stopwatch.Frequency;
    private const int MaxDoublings = 3;

    // Servers count from 0, and all avatars of one have the same kind of skeleton.
    private const int FirstAvatar = 0;

    // Indices come from the network: nobody shall fill the memory with avatars that are made up.
    private const int MaxBodies = 256;

    private readonly object _lock = new();
    private readonly ConcurrentDictionary<int, BodyAnswer?> _bodies = new();
    private volatile bool _areSizesWanted;
    private bool _isAsking;
    private bool _isRequested;
    private bool _isStopped;
    private bool _hasBegun;
    private int _failures;
    private long _failed;
    private volatile bool _hasNewBodies;

    // What others ask, an export for example, is asked only once as well.
    public ServerInquiry Inquiry { get; } = new(options);

    // Called with the sizes of the first avatar, once WantSizes was called.
    public Action<BoneDimensions> SizesLearnt { get; set; } = static _ => { };

    // A connection stands.
    public void Begin()
    {
        Inquiry.Renew();
        lock (_lock)
        {
            _failures = 0;
            _hasBegun = true;
        }

        Ask(isRetry: false);
    }

    // Timer, while a connection stands.
    public void Check(long now)
    {
        bool isDue;
        lock (_lock)
        {
            if (_isAsking)
                return;

            isDue = _failures > 0 && now - _failed > FirstRetry << Math.Min(_failures - 1, MaxDoublings);
        }

        if (isDue || _hasNewBodies)
            Ask(isDue);
    }

    // From now on, and on every connection.
    public void WantSizes()
    {
        _areSizesWanted = true;
        Ask(isRetry: false);
    }

    // Null until the server has told it. The first call makes the timer ask; none waits.
    public SkeletonBody? FindBody(int avatarIndex)
    {
        if (_bodies.TryGetValue(avatarIndex, out BodyAnswer? answer))
            return answer?.GetBody(format.Variant);

        if (avatarIndex >= 0 && _bodies.Count < MaxBodies && _bodies.TryAdd(avatarIndex, null))
            _hasNewBodies = true;

        return null;
    }

    // Asks nothing more of its own accord. An export may still wait for an answer.
    public void Stop()
    {
        lock (_lock)
            _isStopped = true;
    }

    // Ends the questions, without waiting for it.
    public void Dispose()
    {
        Stop();
        Inquiry.Dispose();
    }

    private void Ask(bool isRetry)
    {
        lock (_lock)
        {
            _isRequested = true;
            if (_isAsking || _isStopped || !_hasBegun)
                return;

            _isAsking = true;
        }

        _ = AskAsync(isRetry);
    }

    private async Task AskAsync(bool isRetry)
    {
        while (TryBeginRound())
        {
            bool isComplete = false;
            try
            {
                isComplete = await AskEverythingAsync(isRetry).ConfigureAwait(false);
            }
            catch (ObjectDisposedException)
            {
                // The reader was stopped.
            }
            catch (Exception)
            {
                // A fault of ours, or out of memory: tried again as after any other failure.
            }

            EndRound(isComplete, isRetry);
            isRetry = false;
        }
    }

    private bool TryBeginRound()
    {
        lock (_lock)
        {
            _isAsking = _isRequested && !_isStopped;
            _isRequested = false;
            return _isAsking;
        }
    }

    private void EndRound(bool isComplete, bool isRetry)
    {
        lock (_lock)
        {
            if (isComplete)
                _failures = 0;
            else if (isRetry || _failures == 0)
                (_failures, _failed) = (_failures + 1, Stopwatch.GetTimestamp());
        }
    }

    // False when something has no answer. A server that is silent twice is not asked the rest: that would take very long.
    private async Task<bool> AskEverythingAsync(bool isRetry)
    {
        bool isComplete = true;
        int unanswered = 0;
        _hasNewBodies = false;
        foreach (Func<bool, Task> question in Questions())
        {
            try
            {
                await question(isRetry).ConfigureAwait(false);
            }
            catch (NeuronCommandException exception)
            {
                isComplete = false;
                if (!exception.IsAnswer && ++unanswered > 1)
                    break;
            }
        }

        return isComplete;
    }

    private IEnumerable<Func<bool, Task>> Questions()
    {
        yield return AskForFormatAsync;
        if (_areSizesWanted)
            yield return async isRetry => SizesLearnt(await Inquiry.GetDimensionsAsync(FirstAvatar, isRetry).ConfigureAwait(false));

        foreach (int avatar in _bodies.Keys)
            yield return async isRetry => _bodies[avatar] = await Inquiry.GetBodyAsync(avatar, isRetry).ConfigureAwait(false);
    }

    private async Task AskForFormatAsync(bool isRetry)
    {
        try
        {
            format.Learn(await Inquiry.GetRotationOrderAsync(isRetry).ConfigureAwait(false), variant: null);
            learnt();
            BvhSkeletonMap skeleton = await Inquiry.GetSkeletonAsync(FirstAvatar, isRetry).ConfigureAwait(false);
            format.Learn(order: null, skeleton.Format.Variant);
            format.LearnFailure(null);
        }
        catch (Exception exception) when (exception is not ObjectDisposedException)
        {
            format.LearnFailure(exception is NeuronCommandException ? exception.Message : $"The command channel's answer could not be used: {exception.Message}");
            throw;
        }
        finally
        {
            learnt();
        }
    }
}
